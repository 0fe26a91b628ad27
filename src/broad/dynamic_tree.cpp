#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "broad/finders.hpp"
#include "broad/method_cells.hpp"
#include "broad/persistent_tree.hpp"
#include "core/no_index.hpp"

namespace toccata {
namespace {

/// The box with a tenth of its longest side around it, so that small motions stay inside.
Aabb enlarged(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  const double longest = std::max({size.x, size.y, size.z});
  return longest <= std::numeric_limits<double>::max() ? offset_outward(box, 0.1 * longest) : box;
}

/// A binary tree of boxes that is never made anew as a whole while few of them leave their enlarged ones: what does is
/// taken out, and put in again where the boxes above grow least. (After E. Catto, "Dynamic bounding volume
/// hierarchies", 2019.)
class EnlargedBoxBvh {
 public:
  void build(std::span<const Aabb> boxes) {
    nodes_.clear();
    free_.clear();
    leaves_.assign(boxes.size(), no_index);
    inserted_ = 0;
    std::vector<Index> numbers;
    for (Index number = 0; number < boxes.size(); ++number)
      if (!is_empty(boxes[number])) numbers.push_back(number);
    root_ = numbers.empty() ? no_index : build_over(boxes, numbers, no_index);
  }

  void move(Index number, const Aabb& box) {
    if (leaves_.size() <= number) leaves_.resize(number + std::size_t{1}, no_index);
    const Index leaf = leaves_[number];
    if (leaf != no_index && !is_empty(box) && contains(nodes_[leaf].box, box)) return;
    if (leaf != no_index) take_out(leaf);
    if (!is_empty(box)) put_in(number, enlarged(box));
  }
  /// How many have been put in since all was built.
  [[nodiscard]] std::size_t inserted() const { return inserted_; }

  /// Calls `found` with the number of each leaf whose enlarged box overlaps.
  template <class Found>
  void each_overlap(const Aabb& box, std::vector<Index>& waiting, const Found& found) const {
    waiting.clear();
    if (root_ != no_index) waiting.push_back(root_);
    while (!waiting.empty()) {
      const Node& node = nodes_[waiting.back()];
      waiting.pop_back();
      if (!overlap(node.box, box)) continue;
      if (node.right == no_index) {
        found(node.left);
        continue;
      }
      waiting.push_back(node.left);
      waiting.push_back(node.right);
    }
  }

  /// The nodes of each depth, and the enlarged boxes by themselves.
  void add_cells(BroadPhaseCells& cells) const {
    std::vector<Index> level, below, leaves;
    if (root_ != no_index) level.push_back(root_);
    for (int depth = 0; !level.empty(); ++depth, std::swap(level, below)) {
      below.clear();
      std::vector<Aabb> boxes;
      for (const Index at : level) {
        const Node& node = nodes_[at];
        if (node.right == no_index) {
          leaves.push_back(at);
          continue;
        }
        boxes.push_back(node.box);
        below.insert(below.end(), {node.left, node.right});
      }
      if (boxes.empty()) continue;
      CellsOfGroup group(cells, fmt::format("tree, level {}", depth));
      for (const Aabb& box : boxes) group.add(box);
    }
    if (leaves.empty()) return;
    CellsOfGroup group(cells, "enlarged boxes");
    for (const Index leaf : leaves) group.add(nodes_[leaf].box);
  }

  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + (free_.capacity() + leaves_.capacity()) * sizeof(Index);
  }

 private:
  /// A node. In a leaf `right` is none and `left` is the number of its box.
  struct Node {
    Aabb box;
    Index parent = no_index, left = no_index, right = no_index;
  };

  Index new_node(const Node& node) {
    if (free_.empty()) {
      nodes_.push_back(node);
      return static_cast<Index>(nodes_.size() - 1);
    }
    const Index at = free_.back();
    free_.pop_back();
    nodes_[at] = node;
    return at;
  }

  /// Halves along the axis on which the middles are spread most.
  Index build_over(std::span<const Aabb> boxes, std::span<Index> numbers, Index parent) {
    if (numbers.size() == 1) {
      const Index leaf = new_node({enlarged(boxes[numbers[0]]), parent, numbers[0], no_index});
      leaves_[numbers[0]] = leaf;
      return leaf;
    }
    Aabb middles;
    const auto middle = [&](Index number) { return 0.5 * boxes[number].lower + 0.5 * boxes[number].upper; };
    for (const Index number : numbers) middles = merge(middles, middle(number));
    const Vec3 spread = 0.5 * middles.upper - 0.5 * middles.lower;
    const int axis = spread.x >= spread.y ? (spread.x >= spread.z ? 0 : 2) : (spread.y >= spread.z ? 1 : 2);
    const auto half = static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), numbers.begin() + half, numbers.end(), [&](Index a, Index b) {
      // What is no number, the middle of all, comes last.
      const double at_a = middle(a)[axis], at_b = middle(b)[axis];
      if (std::isnan(at_a) || std::isnan(at_b)) return std::isnan(at_a) != std::isnan(at_b) ? std::isnan(at_b) : a < b;
      return at_a != at_b ? at_a < at_b : a < b;
    });
    const Index node = new_node({{}, parent, no_index, no_index});
    const Index left = build_over(boxes, numbers.first(numbers.size() / 2), node);
    const Index right = build_over(boxes, numbers.subspan(numbers.size() / 2), node);
    nodes_[node].left = left;
    nodes_[node].right = right;
    nodes_[node].box = merge(nodes_[left].box, nodes_[right].box);
    return node;
  }

  void put_in(Index number, const Aabb& box) {
    ++inserted_;
    const Index leaf = new_node({box, no_index, number, no_index});
    leaves_[number] = leaf;
    if (root_ == no_index) {
      root_ = leaf;
      return;
    }
    Index beside = root_;
    while (nodes_[beside].right != no_index) {
      const Node& node = nodes_[beside];
      const auto growth = [&](Index child) {
        return half_area(merge(nodes_[child].box, box)) - half_area(nodes_[child].box);
      };
      beside = growth(node.left) <= growth(node.right) ? node.left : node.right;
    }
    const Index above = nodes_[beside].parent;
    const Index node = new_node({merge(nodes_[beside].box, box), above, beside, leaf});
    nodes_[beside].parent = node;
    nodes_[leaf].parent = node;
    replace_child(above, beside, node);
    refit_from(above);
  }

  void take_out(Index leaf) {
    leaves_[nodes_[leaf].left] = no_index;
    free_.push_back(leaf);
    const Index parent = nodes_[leaf].parent;
    if (parent == no_index) {
      root_ = no_index;
      return;
    }
    const Index other = nodes_[parent].left == leaf ? nodes_[parent].right : nodes_[parent].left;
    const Index above = nodes_[parent].parent;
    nodes_[other].parent = above;
    free_.push_back(parent);
    replace_child(above, parent, other);
    refit_from(above);
  }

  void replace_child(Index parent, Index child, Index by) {
    if (parent == no_index)
      root_ = by;
    else
      (nodes_[parent].left == child ? nodes_[parent].left : nodes_[parent].right) = by;
  }
  /// Upward until nothing changes.
  void refit_from(Index node) {
    for (; node != no_index; node = nodes_[node].parent) {
      const Aabb box = merge(nodes_[nodes_[node].left].box, nodes_[nodes_[node].right].box);
      if (box == nodes_[node].box) return;
      nodes_[node].box = box;
    }
  }

  std::vector<Node> nodes_;
  std::vector<Index> free_;
  std::vector<Index> leaves_;  ///< by number
  Index root_ = no_index;
  std::size_t inserted_ = 0;
};

}  // namespace

std::unique_ptr<PairFinder> make_dynamic_tree() { return std::make_unique<PersistentTree<EnlargedBoxBvh>>(); }

}  // namespace toccata
