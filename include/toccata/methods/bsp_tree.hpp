#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {

struct BspOptions {
  double split_weight = 4;  ///< 0 or more: what a cut triangle costs, beside 1 for each that one side has more
  Index candidates = 8;     ///< 1 … 64: planes of triangles compared at a node, spread evenly over its cell
  bool axis_planes = true;  ///< also planes across the axes through the middle of what is in a cell
  double max_growth = 32;   ///< 1 or more: the tree is given up beyond so many fragments a triangle, and beyond 2²⁸
};

/// What a tree has become.
struct BspStatistics {
  std::size_t triangles = 0;   ///< of the mesh
  std::size_t nodes = 0;       ///< planes, one a node
  std::size_t axis_nodes = 0;  ///< those of the nodes that are across an axis
  std::size_t leaves = 0;      ///< cells that are not cut: one more than nodes
  std::size_t fragments = 0;   ///< what the planes have left of the triangles, all kept
  std::size_t splits = 0;      ///< how often a fragment was cut in two: fragments less triangles
  std::size_t depth = 0;       ///< most nodes from the root to a leaf
  double mean_depth = 0;       ///< nodes above a leaf, on average over the leaves
  std::size_t bytes = 0;       ///< without the model

  [[nodiscard]] double growth() const { return static_cast<double>(fragments) / static_cast<double>(triangles); }
};

/// Where a point lies, and of a boundary on which triangle.
struct BspLocation : PointLocation {
  Index triangle = 0;  ///< the least of those that it lies on; 0 where it lies on none
};

/// A triangle of the mesh, or what planes have left of it.
struct BspFragment {
  Index triangle = 0;
  std::span<const Vec3> corners;  ///< convex, turning as the triangle; rounded, to draw. Lives as long as the tree
};

/// Planes that a trace looks at beside those of the tree, moved out likewise.
enum class BspBevels {
  none,
  edges_and_corners,  ///< at a cell, across what up to eight of its planes make with each other
};

/// What a shape that moves meets when it is a point that moves among planes which have been moved out. It need not be
/// met by the shape.
struct BspTrace {
  double time = 0;  ///< as a share of the way: no part of the solid is met before it, which is proved
  Vec3 normal{};    ///< unit, against the motion, of the plane that is reached then; zero if it was before the start
  friend constexpr bool operator==(const BspTrace&, const BspTrace&) = default;
};

/// A binary space partitioning tree of a closed mesh: space is cut by a plane, each half by another, until no surface
/// is left in a cell, which then lies inside or outside as a whole (H. Fuchs, Z. M. Kedem, B. F. Naylor, "On visible
/// surface generation by a priori tree structures", 1980; W. C. Thibault, B. F. Naylor, "Set operations on polyhedra
/// using binary space partitioning trees", 1987). Planes are those of triangles of the mesh, and planes across an axis.
///
/// Exact: no point at which an edge is cut is ever rounded where it decides anything. A cut is known by what it is cut
/// of, an edge of a triangle or its plane, and by the planes that cut it, and every side of a plane is an exact sign
/// (docs/methods/space-partitions.md#bsp-trees). In the mesh's own frame. Immutable; copies share all, and any number
/// of threads may ask.
class BspTree {
 public:
  /// Throws Error when the model is no mesh, the mesh is open, intersects itself, or has a triangle without area,
  /// naming them; for options out of their range; and when cutting makes more fragments than `max_growth` allows.
  explicit BspTree(const Model& solid, const BspOptions& options = {});

  /// The same answer as `locate` of the model, exact: a few comparisons for each level of the tree. Throws Error when
  /// the point is not finite.
  [[nodiscard]] BspLocation locate(const Vec3& point) const;

  /// The same answer as `cast_ray` of the model, with the same triangle, time and point (only `lower` may be another
  /// bound): the cells along the ray are visited in their order, until one has a triangle that is met. Throws Error
  /// when a number is not finite or the motion is zero.
  [[nodiscard]] std::optional<RayHit> cast_ray(const Vec3& origin, const Vec3& motion) const;

  /// Whether the closed segment has a point in common with the solid. Exact. Throws Error when a number is not finite,
  /// and when the ends are farther apart along an axis than the greatest double.
  [[nodiscard]] bool overlap(const Vec3& from, const Vec3& to) const;

  /// Whether the shape, in the mesh's own frame, has a point in common with the solid. Exact, as `overlap` of the
  /// model.
  [[nodiscard]] bool overlap(const PosedPolytope& shape) const;

  /// Expanded planes (S. Melax, "Dynamic plane shifting BSP traversal", 2000; Quake's traces): the shape, in the mesh's
  /// own frame, moves by `motion` without turning; every plane is moved out by how far the shape reaches across it, to
  /// either side, and the shape is a point that goes through the cells. In front of a face that is exact, but where
  /// planes meet at an edge or a corner a cell that is grown so is too large, at sharp ones as far as the box of the
  /// mesh allows, which is moved out too. So it reports hits that are none, but never none where there is one: what is
  /// free is proved, and there is no trace then. With bevels it reports fewer such hits. Throws Error when the motion
  /// is not finite.
  [[nodiscard]] std::optional<BspTrace> trace(const PosedPolytope& shape, const Vec3& motion,
                                              BspBevels bevels = BspBevels::none) const;

  /// The accurate form: `cast_shape` of the model, with the same answer (only `lower` may be another bound, and of
  /// triangles that are met at the start the least is named). The cells are visited as a trace visits them, and the
  /// triangles in the planes that are met are cast exactly, until one is met. Throws Error when the motion is not
  /// finite.
  [[nodiscard]] std::optional<ShapeHit> cast_shape(const PosedPolytope& shape, const Vec3& motion) const;

  /// All fragments in an order in which one may be painted over those before it: seen from the eye, none hides a later
  /// one. Exact. Throws Error when the eye is not finite.
  [[nodiscard]] std::vector<BspFragment> back_to_front(const Vec3& eye) const;

  [[nodiscard]] const BspStatistics& statistics() const;

  struct Parts;

 private:
  std::shared_ptr<const Parts> parts_;
};

}  // namespace toccata
