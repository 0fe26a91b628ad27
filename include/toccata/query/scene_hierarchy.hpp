#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/trees/bvh.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {

/// A scene's tree of nodes as a bounding-volume hierarchy ("scene graphs as bounding volume hierarchies"): inner nodes
/// are nodes of the scene or were put in, leaves hold one object each, and every box is fitted to the objects below it,
/// in the world. A node has as many children as the scene gives it, one or thousands; walks take it as any other tree.
struct SceneHierarchy {
  Bvh<Aabb, 0> tree;                              ///< arity 0: any; its items are numbers of Scene::objects
  std::vector<std::optional<Index>> scene_nodes;  ///< for each of its nodes the one of Scene::nodes it stands for
  /// Objects that have no box with an end: half-spaces. They are in no leaf.
  std::vector<Index> unbounded;
};

/// The scene's nodes as they are, and their objects below them in the scene's order. What has no node hangs on a root
/// that is put above all where there is no single one. Nodes without objects below are left out. Throws Error naming
/// the object where a pose is one that the shape may not have.
[[nodiscard]] SceneHierarchy hierarchy_of(const Scene& scene);

/// How a bad hierarchy is made better. The scene itself stays as it is.
enum class Rebalance {
  /// All inner nodes are made anew from the objects' boxes, two children each, by the surface-area heuristic
  /// (build_bvh in trees/builders.hpp). None stands for a node of the scene.
  rebuild,
  /// Nodes that are good stay, with what they stand for: those whose box is less than 0.8 of their parent's (by area)
  /// and shares less than a quarter with boxes beside it. Others, and those with a single child, give way to
  /// their children, and more than two children of one node are grouped by the surface-area heuristic.
  cure,
};

[[nodiscard]] SceneHierarchy rebalanced(const SceneHierarchy& hierarchy, Rebalance how = Rebalance::rebuild);

/// The nodes that are so many steps below the root.
struct HierarchyLevel {
  std::size_t nodes = 0;
  std::size_t leaves = 0;
  std::size_t most_children = 0;              ///< the most children of one node
  std::size_t sibling_pairs = 0;              ///< each two children of one of these nodes
  std::size_t overlapping_sibling_pairs = 0;  ///< those of which the boxes overlap; touching counts
};

/// What one test costs, in any unit; with 1 and 1 the cost is the number of tests.
struct TestCosts {
  double volume_test = 1;  ///< C_bv
  double item_test = 1;    ///< C_p
};

struct HierarchyReport {
  std::vector<HierarchyLevel> levels;  ///< the root's first
  std::size_t nodes = 0;
  std::size_t leaves = 0;
  double mean_depth = 0;  ///< of a leaf; the root's is 0
  std::size_t most_children = 0;
  std::size_t sibling_pairs = 0;
  std::size_t overlapping_sibling_pairs = 0;
  /// What finding all pairs of objects with overlapping boxes takes, by walking the hierarchy against itself: N_bv and
  /// N_p of the cost function (walk.hpp). Counted, so the same on every machine.
  WalkCounts counts;

  /// F = N_bv · C_bv + N_p · C_p. Nothing is updated: N_u is 0.
  [[nodiscard]] double cost(const TestCosts& costs = {}) const;
};

/// Takes as long as finding all pairs in the hierarchy takes: with the square of the number of children of a node.
[[nodiscard]] HierarchyReport report_of(const SceneHierarchy& hierarchy);

/// Each two objects whose boxes overlap (touching counts), ascending; found by walking the hierarchy against itself.
/// Every hierarchy of the same objects gives the same.
[[nodiscard]] std::vector<ItemPair> overlapping_objects(const SceneHierarchy& hierarchy);

}  // namespace toccata
