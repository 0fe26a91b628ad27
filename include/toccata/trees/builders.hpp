#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/bounds/volume.hpp"
#include "toccata/core/index.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/trees/bvh.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// How a hierarchy over triangles is found. None depends on the volume: every method serves every volume. Where things
/// of growing size lie in each other, agglomeration and insertion may make a tree as deep as there are of them; walks
/// keep stacks of their own.
enum class BvhMethod {
  /// From the top down by the plane through the mean across the direction of greatest variance, else of the next
  /// (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996); in halves where no such plane parts the centroids.
  mean,
  /// From the top down into halves, by the order along the longest axis of the centroids.
  median,
  /// From the top down where the surface-area heuristic (SAH) is least (build.hpp).
  heuristic,
  /// From the bottom up (PLOC): of neighbours along a space-filling curve those are merged that are each other's
  /// nearest (D.
  /// Meister, J. Bittner, "Parallel locally-ordered clustering for bounding volume hierarchy construction", 2018).
  agglomeration,
  /// One by one, each where it makes the boxes grow least (J. Goldsmith, J. Salmon, "Automatic creation of object
  /// hierarchies for ray tracing", 1987).
  insertion,
  /// LBVH: along a space-filling curve, split where its codes differ first (C. Lauterbach et al., "Fast BVH
  /// construction on
  /// GPUs", 2009).
  morton,
  /// From the top down: the box of the centroids is cut into as many parts of one volume as a node may have children
  /// (four: in halves, and these in halves again; always across the longest axis). Each that holds a centroid is a
  /// child, of whatever size its triangles are; in halves by number where the centroids coincide.
  equal_regions,
};

/// Whether a tree is built from the top down by a stack of tasks or by functions that call themselves: the tree is the
/// same.
enum class BvhDriver { iterative, recursive };

struct BvhOptions {
  BvhMethod method = BvhMethod::heuristic;
  Index leaf_size = 1;  ///< at most this many triangles in a leaf; at least 1
  BvhDriver driver = BvhDriver::iterative;
  /// Volumes are fitted by all of them, and all but `heuristic` and `insertion` find their shape so too, except for the
  /// sort of `morton`.
  int threads = own_thread;
};

struct NoVolume {};

/// A hierarchy before volumes are put around its nodes. Items are in the order of the leaves, so that those below a
/// node are a run of them.
struct BvhShape {
  std::vector<BvhNode<NoVolume>> nodes;
  std::vector<Index> items;
};

/// A tree with up to `arity` children a node, which is 2 to 8. The same triangles give the same shape. Throws Error for
/// another arity, and for coordinates that are not finite or above 2^1000.
[[nodiscard]] BvhShape build_bvh_shape(std::span<const Triangle> triangles, int arity, const BvhOptions& options);

/// The items below every node, as runs of the items' order.
struct ItemRun {
  Index first = 0;
  Index count = 0;
};
[[nodiscard]] std::vector<ItemRun> item_runs(const BvhShape& shape);

/// A hierarchy of which every node's volume is fitted to the triangles below it.
template <BoundingVolume Volume, int Arity = 2>
[[nodiscard]] Bvh<Volume, Arity> build_bvh(std::span<const Triangle> triangles, const BvhOptions& options = {}) {
  const BvhShape shape = build_bvh_shape(triangles, Arity, options);
  std::vector<Triangle> ordered;
  ordered.reserve(triangles.size());
  for (const Index item : shape.items) ordered.push_back(triangles[item]);
  Bvh<Volume, Arity> tree;
  tree.items = shape.items;
  tree.nodes.resize(shape.nodes.size());
  const std::vector<ItemRun> runs = item_runs(shape);
  parallel_for(runs.size(), options.threads, [&](std::size_t i) {
    const BvhNode<NoVolume>& node = shape.nodes[i];
    const auto below = std::span<const Triangle>(ordered).subspan(runs[i].first, runs[i].count);
    tree.nodes[i] = {fit<Volume>(below), node.first, node.count, node.child_count};
  });
  tree.built_size = 0;
  for (const BvhNode<Volume>& node : tree.nodes) tree.built_size += half_area(node.volume);
  return tree;
}

/// How even a hierarchy is.
struct BvhBalance {
  std::size_t nodes = 0;
  std::size_t leaves = 0;
  int least_depth = 0;  ///< of a leaf; the root's is 0
  int greatest_depth = 0;
  double mean_depth = 0;
  int best_depth = 0;  ///< the least greatest depth that so many leaves can have
};

[[nodiscard]] BvhBalance balance_of(const BvhShape& shape, int arity);

template <class Volume, int Arity>
[[nodiscard]] BvhBalance balance_of(const Bvh<Volume, Arity>& tree) {
  BvhShape shape;
  for (const auto& node : tree.nodes) shape.nodes.push_back({{}, node.first, node.count, node.child_count});
  return balance_of(shape, Arity);
}

/// Puts the volumes around triangles that have moved: leaves are fitted anew, inner nodes merged from their children,
/// from the last node to the first. `triangles` are numbered as when the tree was built. A tree of unknown built_size
/// is taken as just built.
template <BoundingVolume Volume, int Arity>
Refit refit(Bvh<Volume, Arity>& tree, std::span<const Triangle> triangles) {
  if (tree.built_size < 0) {
    tree.built_size = 0;
    for (const auto& node : tree.nodes) tree.built_size += half_area(node.volume);
  }
  double size = 0;
  std::vector<Triangle> below;
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    BvhNode<Volume>& node = tree.nodes[i];
    if (node.is_leaf()) {
      below.clear();
      for (Index k = 0; k < node.count; ++k) below.push_back(triangles[tree.items[node.first + k]]);
      node.volume = fit<Volume>(std::span<const Triangle>(below));
    } else {
      Volume merged = tree.nodes[node.first].volume;
      for (Index k = 1; k < node.child_count; ++k) merged = merge(merged, tree.nodes[node.first + k].volume);
      node.volume = merged;
    }
    size += half_area(node.volume);
  }
  return {tree.nodes.size(), size == tree.built_size ? 1 : size / tree.built_size};
}

struct BuildOptions {
  Index leaf_size = 4;  ///< at most this many items in a leaf; at least 1
};

/// A hierarchy over items that are given by their boxes (item i has boxes[i]; none empty). Splits from the top down
/// where the surface-area heuristic is least among 16 slabs along the longest axis of the centres (J. Goldsmith, J.
/// Salmon, "Automatic creation of object hierarchies for ray tracing", 1987; I. Wald, "On fast construction of
/// SAH-based bounding volume hierarchies", 2007), and in halves where centres coincide. The same boxes give the same
/// tree.
[[nodiscard]] Bvh<Aabb> build_bvh(std::span<const Aabb> boxes, const BuildOptions& options = {});

}  // namespace toccata
