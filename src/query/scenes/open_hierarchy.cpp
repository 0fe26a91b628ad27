#include "query/scenes/open_hierarchy.hpp"

#include <utility>

#include "toccata/trees/builders.hpp"

namespace toccata {

SceneHierarchy closed_hierarchy(const std::vector<OpenNode>& nodes, Index root) {
  SceneHierarchy result;
  if (is_empty(nodes[root].box)) return result;
  std::vector<Index> order{root};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const OpenNode& node = nodes[order[i]];
    BvhNode<Aabb> closed{node.box, static_cast<Index>(order.size()), 0, static_cast<Index>(node.children.size())};
    if (node.object) {
      closed.first = static_cast<Index>(result.tree.items.size());
      closed.count = 1;
      result.tree.items.push_back(*node.object);
    }
    result.tree.nodes.push_back(closed);
    result.scene_nodes.push_back(node.scene_node);
    order.insert(order.end(), node.children.begin(), node.children.end());
  }
  return result;
}

std::vector<OpenNode> open_hierarchy(const SceneHierarchy& hierarchy) {
  std::vector<OpenNode> nodes;
  nodes.reserve(hierarchy.tree.nodes.size());
  for (std::size_t i = 0; i < hierarchy.tree.nodes.size(); ++i) {
    const BvhNode<Aabb>& node = hierarchy.tree.nodes[i];
    OpenNode& open = nodes.emplace_back(OpenNode{node.volume, hierarchy.scene_nodes[i], std::nullopt});
    if (node.is_leaf()) open.object = hierarchy.tree.items[node.first];
    for (Index child = 0; child < node.child_count; ++child) open.children.push_back(node.first + child);
  }
  return nodes;
}

std::vector<Index> grouped(std::vector<OpenNode>& nodes, const std::vector<Index>& members) {
  if (members.size() <= 2) return members;
  std::vector<Aabb> boxes;
  boxes.reserve(members.size());
  for (const Index member : members) boxes.push_back(nodes[member].box);
  const Bvh<Aabb> tree = build_bvh(boxes, {.leaf_size = 1});
  // Its root is the node whose children are asked for; what is below is put in.
  std::vector<Index> number_of(tree.nodes.size());
  for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
    const BvhNode<Aabb>& node = tree.nodes[i];
    number_of[i] = node.is_leaf() ? members[tree.items[node.first]] : static_cast<Index>(nodes.size());
    if (!node.is_leaf()) nodes.push_back({node.volume, std::nullopt, std::nullopt});
  }
  const auto children_of = [&](const BvhNode<Aabb>& node) {
    return std::vector<Index>{number_of[node.first], number_of[node.first + 1]};
  };
  for (std::size_t i = 1; i < tree.nodes.size(); ++i)
    if (!tree.nodes[i].is_leaf()) nodes[number_of[i]].children = children_of(tree.nodes[i]);
  return children_of(tree.nodes[0]);
}

}  // namespace toccata
