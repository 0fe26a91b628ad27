#include "methods/cost/cost_walk.hpp"

namespace toccata {
namespace {

std::vector<Triangle> in_order(std::span<const Triangle> triangles, std::span<const Index> items) {
  std::vector<Triangle> ordered;
  ordered.reserve(items.size());
  for (const Index item : items) ordered.push_back(triangles[item]);
  return ordered;
}

Bvh<NodeNumber, 8> numbered(BvhShape shape) {
  Bvh<NodeNumber, 8> tree;
  tree.nodes.reserve(shape.nodes.size());
  for (const BvhNode<NoVolume>& node : shape.nodes)
    tree.nodes.push_back({{static_cast<Index>(tree.nodes.size())}, node.first, node.count, node.child_count});
  tree.items = std::move(shape.items);
  return tree;
}

}  // namespace

CostHierarchy::CostHierarchy(std::span<const Triangle> triangles_of_mesh, int arity_of_nodes, const BvhOptions& options)
    : triangles(triangles_of_mesh), arity(arity_of_nodes), build_ns(0) {
  BvhShape shape;
  build_ns = nanoseconds_of([&] { shape = build_bvh_shape(triangles, arity, options); });
  runs = item_runs(shape);
  balance = balance_of(shape, arity);
  ordered = in_order(triangles, shape.items);
  tree = numbered(std::move(shape));
}

CostHierarchy CostHierarchy::over(std::span<const Triangle> moved) const {
  CostHierarchy hierarchy = *this;
  hierarchy.triangles = moved;
  hierarchy.ordered = in_order(moved, tree.items);
  return hierarchy;
}

}  // namespace toccata
