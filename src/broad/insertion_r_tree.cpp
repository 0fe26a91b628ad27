#include <vector>

#include <fmt/format.h>

#include "broad/finders.hpp"
#include "broad/method_cells.hpp"
#include "broad/persistent_tree.hpp"
#include "partitions/r_tree_nodes.hpp"

namespace toccata {
namespace {

/// An R-tree of the boxes as they are, packed once and then changed box by box.
class ChangedRTree {
 public:
  void build(std::span<const Aabb> boxes) {
    nodes_.build(boxes);
    inserted_ = 0;
  }

  void move(Index number, const Aabb& box) {
    if (!nodes_.contains(number)) {
      if (is_empty(box)) return;
      ++inserted_;
      return nodes_.insert(number, box);
    }
    if (is_empty(box)) return nodes_.remove(number);
    if (!nodes_.move(number, box)) ++inserted_;
  }

  [[nodiscard]] std::size_t inserted() const { return inserted_; }

  template <class Found>
  void each_overlap(const Aabb& box, std::vector<Index>& waiting, const Found& found) const {
    nodes_.each_overlap(box, waiting, [&](Index number, const Aabb&) { found(number); });
  }

  void add_cells(BroadPhaseCells& cells) const {
    std::vector<std::vector<Aabb>> levels;  // the root's first
    std::uint32_t highest = 0;
    nodes_.each_node([&](const RTreeNodes::Node& node) {
      if (levels.empty()) {
        highest = node.level;
        levels.resize(highest + std::size_t{1});
      }
      if (node.count > 0) levels[highest - node.level].push_back(RTreeNodes::box_of(node));
    });
    for (std::size_t depth = 0; depth < levels.size(); ++depth) {
      if (levels[depth].empty()) continue;
      CellsOfGroup group(cells, fmt::format("tree, level {}", depth));
      for (const Aabb& box : levels[depth]) group.add(box);
    }
  }

  [[nodiscard]] std::size_t bytes() const { return nodes_.bytes(); }

 private:
  RTreeNodes nodes_;
  std::size_t inserted_ = 0;
};

}  // namespace

std::unique_ptr<PairFinder> make_r_tree() { return std::make_unique<PersistentTree<ChangedRTree>>(); }

}  // namespace toccata
