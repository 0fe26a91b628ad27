#include <algorithm>
#include <utility>

#include "query/scenes/open_hierarchy.hpp"

namespace toccata {
namespace {

constexpr double most_of_parent = 0.8;
constexpr double most_shared = 0.25;

Aabb common_part(const Aabb& a, const Aabb& b) {
  return {{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)},
          {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y), std::min(a.upper.z, b.upper.z)}};
}

/// Replaces, from the root down, the children that are not worth keeping by theirs, and groups what is left.
class Cure {
 public:
  explicit Cure(const SceneHierarchy& hierarchy) : nodes_(open_hierarchy(hierarchy)) {}

  SceneHierarchy cured() {
    std::vector<Index> open{0};
    while (!open.empty()) {
      const Index number = open.back();
      open.pop_back();
      const std::vector<Index> kept = kept_below(number);
      for (const Index child : kept)
        if (!is_leaf(child)) open.push_back(child);
      nodes_[number].children = grouped(nodes_, kept);
    }
    return closed_hierarchy(nodes_, 0);
  }

 private:
  [[nodiscard]] bool is_leaf(Index number) const { return nodes_[number].object.has_value(); }

  /// What is to be below the node, for its children.
  [[nodiscard]] std::vector<Index> kept_below(Index number) const {
    std::vector<Index> kept, open = nodes_[number].children;
    while (!open.empty()) {
      const Index child = open.back();
      open.pop_back();
      if (is_leaf(child) || is_worth_keeping(child, number, kept, open)) {
        kept.push_back(child);
      } else {
        const std::vector<Index>& below = nodes_[child].children;
        open.insert(open.end(), below.begin(), below.end());
      }
    }
    std::sort(kept.begin(), kept.end());
    return kept;
  }

  /// `kept` and `open` are beside it.
  [[nodiscard]] bool is_worth_keeping(Index child, Index parent, const std::vector<Index>& kept,
                                      const std::vector<Index>& open) const {
    const double area = half_area(nodes_[child].box);
    // Where areas are all 0 nothing is kept, and all is grouped anew.
    if (nodes_[child].children.size() == 1 || !(area < most_of_parent * half_area(nodes_[parent].box))) return false;
    double shared = 0;
    for (const auto* siblings : {&kept, &open})
      for (const Index sibling : *siblings)
        if (overlap(nodes_[child].box, nodes_[sibling].box))
          shared += half_area(common_part(nodes_[child].box, nodes_[sibling].box));
    return shared < most_shared * area;
  }

  std::vector<OpenNode> nodes_;
};

/// The root is made anew too.
SceneHierarchy rebuilt(const SceneHierarchy& hierarchy) {
  std::vector<OpenNode> nodes = open_hierarchy(hierarchy);
  std::vector<Index> leaves;
  for (Index i = 0; i < nodes.size(); ++i)
    if (nodes[i].object) leaves.push_back(i);
  OpenNode root{nodes[0].box, std::nullopt, std::nullopt};
  root.children = grouped(nodes, leaves);
  if (leaves.size() == 1) return closed_hierarchy(nodes, leaves[0]);
  nodes.push_back(std::move(root));
  return closed_hierarchy(nodes, static_cast<Index>(nodes.size() - 1));
}

}  // namespace

SceneHierarchy rebalanced(const SceneHierarchy& hierarchy, Rebalance how) {
  if (hierarchy.tree.nodes.empty()) return hierarchy;
  SceneHierarchy result = how == Rebalance::rebuild ? rebuilt(hierarchy) : Cure(hierarchy).cured();
  result.unbounded = hierarchy.unbounded;
  return result;
}

}  // namespace toccata
