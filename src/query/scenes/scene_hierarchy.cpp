#include "toccata/query/scene_hierarchy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "math/constants.hpp"
#include "query/posed_shape.hpp"
#include "query/scenes/open_hierarchy.hpp"

namespace toccata {
namespace {

Aabb world_box(const SceneObject& object) {
  Aabb box;
  if (const auto mesh = object.mesh()) {
    for (const auto& corners : mesh->triangles())
      for (const Index corner : corners) box = merge(box, transform(object.pose, mesh->vertices()[corner]));
    return box;
  }
  const Model model(object.shape);
  // The shape's box is asked for, as a surface or as a solid.
  const PosedModel posed = pose_model(model, object.pose, Solid::automatic, fmt::format("'{}'", object.name));
  for (const PosedPart& part : posed.parts) box = merge(box, world_box(part.shape));
  return box;
}

bool is_bounded(const Aabb& box) { return is_finite(box.lower) && is_finite(box.upper); }

/// The scene's nodes by their numbers, then the leaves, then a root above all.
class SceneOpener {
 public:
  explicit SceneOpener(const Scene& scene) : scene_(scene) {
    for (Index i = 0; i < scene.nodes.size(); ++i) nodes_.push_back({{}, i, std::nullopt});
  }

  SceneHierarchy hierarchy() {
    std::vector<Index> unbounded;
    for (Index i = 0; i < scene_.objects.size(); ++i) {
      const Aabb box = world_box(scene_.objects[i]);
      if (is_bounded(box))
        nodes_.push_back({box, std::nullopt, i});
      else
        unbounded.push_back(i);
    }
    SceneHierarchy result = closed_hierarchy(nodes_, joined());
    result.unbounded = std::move(unbounded);
    return result;
  }

 private:
  /// Puts everything below its parent, from the last to the first, so that nodes are whole when their turn comes.
  /// Returns the root.
  Index joined() {
    const auto root = static_cast<Index>(nodes_.size());
    nodes_.push_back({});
    for (Index i = root; i-- > 0;) {
      if (is_empty(nodes_[i].box)) continue;
      OpenNode& parent = nodes_[parent_of(i).value_or(root)];
      parent.box = merge(parent.box, nodes_[i].box);
      parent.children.push_back(i);
    }
    for (OpenNode& node : nodes_) std::reverse(node.children.begin(), node.children.end());
    return nodes_[root].children.size() == 1 ? nodes_[root].children[0] : root;
  }

  [[nodiscard]] std::optional<Index> parent_of(Index i) const {
    return nodes_[i].object ? scene_.objects[*nodes_[i].object].node : scene_.nodes[i].parent;
  }

  const Scene& scene_;
  std::vector<OpenNode> nodes_;
};

/// Takes every pair of leaves whose boxes overlap.
struct AllPairs {
  std::vector<ItemPair> found{};
  double bound(const Aabb& a, const Aabb& b) const { return overlap(a, b) ? 0 : infinity; }
  double limit() const { return 0; }
  void visit(std::span<const ItemPair> pairs) { found.insert(found.end(), pairs.begin(), pairs.end()); }
};

/// The same without keeping them.
struct PairCount {
  double bound(const Aabb& a, const Aabb& b) const { return overlap(a, b) ? 0 : infinity; }
  double limit() const { return 0; }
  void visit(std::span<const ItemPair>) {}
};

void add_children(const Bvh<Aabb, 0>& tree, const BvhNode<Aabb>& node, HierarchyLevel& level) {
  level.most_children = std::max<std::size_t>(level.most_children, node.child_count);
  for (Index i = 0; i < node.child_count; ++i)
    for (Index j = i + 1; j < node.child_count; ++j) {
      ++level.sibling_pairs;
      const bool overlapping = overlap(tree.nodes[node.first + i].volume, tree.nodes[node.first + j].volume);
      level.overlapping_sibling_pairs += overlapping ? 1 : 0;
    }
}

}  // namespace

SceneHierarchy hierarchy_of(const Scene& scene) { return SceneOpener(scene).hierarchy(); }

double HierarchyReport::cost(const TestCosts& costs) const {
  return static_cast<double>(counts.volume_tests) * costs.volume_test +
         static_cast<double>(counts.items) * costs.item_test;
}

HierarchyReport report_of(const SceneHierarchy& hierarchy) {
  HierarchyReport report;
  const Bvh<Aabb, 0>& tree = hierarchy.tree;
  std::vector<std::size_t> depths(tree.nodes.size(), 0);
  double sum = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const BvhNode<Aabb>& node = tree.nodes[i];
    if (depths[i] == report.levels.size()) report.levels.emplace_back();
    HierarchyLevel& level = report.levels[depths[i]];
    ++level.nodes;
    if (node.is_leaf()) {
      ++level.leaves;
      sum += static_cast<double>(depths[i]);
    }
    add_children(tree, node, level);
    for (Index child = 0; child < node.child_count; ++child) depths[node.first + child] = depths[i] + 1;
  }
  for (const HierarchyLevel& level : report.levels) {
    report.nodes += level.nodes;
    report.leaves += level.leaves;
    report.most_children = std::max(report.most_children, level.most_children);
    report.sibling_pairs += level.sibling_pairs;
    report.overlapping_sibling_pairs += level.overlapping_sibling_pairs;
  }
  if (report.leaves > 0) report.mean_depth = sum / static_cast<double>(report.leaves);
  PairCount question;
  report.counts = walk_self(tree, question);
  return report;
}

std::vector<ItemPair> overlapping_objects(const SceneHierarchy& hierarchy) {
  AllPairs question;
  walk_self(hierarchy.tree, question);
  std::sort(question.found.begin(), question.found.end());
  return question.found;
}

}  // namespace toccata
