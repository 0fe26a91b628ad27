#pragma once

#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "math/filter.hpp"
#include "math/scaled_integer.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// A plane that cuts space, by what it was made from. With T triangles, a number below T is the plane of a triangle,
/// one below 10 T a plane through an edge, nine for each triangle, and from there on one across an axis, in the order
/// in which they were made.
using BspPlane = Index;

/// The plane through the edge of a triangle, from that corner to the next, that is parallel to `axis`.
struct EdgePlane {
  Index triangle = 0;
  Index edge = 0;
  int axis = 0;
};

struct EdgeEnds {
  Vec3 from;
  Vec3 to;
};

/// All x of which coordinate `axis` is `value`.
struct AxisPlane {
  int axis = 0;
  double value = 0;
};

/// Local places are counted from the middle of the mesh, in a unit, a power of two, in which none within its box has a
/// coordinate greater than 1. So what rounding loses is measured by the size of the mesh, not by how far it is from the
/// origin, and nothing under- or overflows because all of it is small or large.
class BspFrame {
 public:
  explicit BspFrame(const Aabb& box);

  /// Each coordinate is off by at most 2^-53 of itself, or 2^-1074.
  [[nodiscard]] Vec3 local(const Vec3& p) const { return way(p - middle_); }
  /// The same of a difference of places.
  [[nodiscard]] Vec3 way(const Vec3& difference) const { return to_unit_ * difference; }
  [[nodiscard]] Vec3 world(const Vec3& local) const { return local / to_unit_ + middle_; }
  [[nodiscard]] bool contains(const Vec3& p) const { return overlap(box_, Aabb{p, p}); }

  [[nodiscard]] const Aabb& box() const { return box_; }
  [[nodiscard]] const Vec3& middle() const { return middle_; }

 private:
  Aabb box_;
  Vec3 middle_;
  double to_unit_ = 1;
};

/// A plane in rounded numbers: the height of a local place above it, times the length of the normal, and a bound on its
/// error for every point within the box of the mesh.
///
/// The proof. Let ε = 2^-53, and q and a the local places of the point and of a corner of the triangle, before and
/// after their rounding no greater than 1. The exact height is n · (q − a) with exact q and a. Each coordinate of the
/// normal ñ that is computed is off by at most 4εm of its magnitude m (three factors 1 + δ: two differences of corners
/// and a product, and the last difference), and |ñ| ≤ (1 + 4ε)m. So, per coordinate, replacing n by ñ costs 4εm · 2,
/// rounding q and a costs εm · 2, and the two inner products of three terms, each with at most four roundings in a row,
/// and their difference cost 4εm · 2 + εm · 2. The sum is 20εm, and second orders and the rounding of the bound itself
/// are less than another 2εm. The bound is 32εm. `filter::floor` is more than what underflow can lose: some dozens of
/// 2^-1074. Overflow makes the bound infinite or NaN, and then nothing is certain.
///
/// The normal of a plane through an edge is two coordinates of a difference of corners, each off by at most εm.
struct RoundedBspPlane {
  Vec3 normal;
  double offset = 0;
  double bound = 0;

  static constexpr double share = 0x1p-48;

  [[nodiscard]] double height(const Vec3& local) const { return dot(normal, local) - offset; }
  /// What being off by one unit along every axis changes of the height, rounded upwards.
  [[nodiscard]] double slope() const { return 0x1.00001p0 * sum_of_magnitudes(normal); }
};

/// n · x = offset, over the grid of `BspArithmetic`.
struct IntegerPlane {
  IntegerRow normal;
  Integer offset;
};

/// point / weight over the same grid; the weight is positive, and 0 where there is no such point.
struct IntegerPoint {
  IntegerRow point;
  Integer weight;
};

/// The planes of a mesh, rounded and exact.
class BspPlanes {
 public:
  BspPlanes(const TriangleMesh& mesh, const BspFrame& frame);

  [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
  [[nodiscard]] Triangle triangle(Index number) const;
  [[nodiscard]] Index triangle_count() const { return mesh_->triangle_count(); }
  [[nodiscard]] bool is_triangle(BspPlane plane) const { return plane < triangle_count(); }
  [[nodiscard]] bool is_axis(BspPlane plane) const { return plane >= 10 * triangle_count(); }
  [[nodiscard]] const AxisPlane& axis_plane(BspPlane plane) const {
    return axis_planes_[plane - 10 * triangle_count()];
  }
  /// The edge plane with this number, which is neither of a triangle nor across an axis.
  [[nodiscard]] EdgePlane edge_plane(BspPlane plane) const;
  [[nodiscard]] EdgeEnds edge_of(const EdgePlane& plane) const;
  [[nodiscard]] std::size_t bytes() const { return axis_planes_.capacity() * sizeof(AxisPlane); }

  BspPlane add(const AxisPlane& plane);
  /// That plane through an edge which is steepest upon the triangle: it has nothing else in common with it than the
  /// line of the edge.
  [[nodiscard]] BspPlane through_edge(Index triangle, Index edge) const;

  [[nodiscard]] RoundedBspPlane rounded(BspPlane plane) const;
  [[nodiscard]] RoundedBspPlane rounded(const AxisPlane& plane) const;
  [[nodiscard]] RoundedBspPlane rounded(const EdgePlane& plane) const;

  /// The side on which a point lies: positive in front, to where the normal points. Exact.
  [[nodiscard]] Sign side(const Vec3& point, BspPlane plane) const;

 private:
  const TriangleMesh* mesh_;
  const BspFrame* frame_;
  std::vector<AxisPlane> axis_planes_;
};

/// Points that are known by planes, exactly, over a grid of which every coordinate of the mesh is a whole multiple,
/// with a unit for each axis. (Stretching an axis keeps every side of every plane.)
class BspArithmetic {
 public:
  BspArithmetic(const BspPlanes& planes, const BspFrame& frame);

  /// Where the line through two vertices meets a plane that has them strictly on both sides.
  [[nodiscard]] IntegerPoint on_edge(const Vec3& from, const Vec3& to, BspPlane plane);
  /// Where three planes meet that have no direction in common. Nowhere, where they have one.
  [[nodiscard]] IntegerPoint where_meet(BspPlane p, BspPlane q, BspPlane r);

  [[nodiscard]] Sign side(const IntegerPoint& point, BspPlane plane);

  /// Its local place, each coordinate rounded once.
  [[nodiscard]] Vec3 place(const IntegerPoint& point) const;

 private:
  [[nodiscard]] IntegerRow on_grid(const Vec3& point) const;
  [[nodiscard]] IntegerPlane made(BspPlane plane) const;
  [[nodiscard]] IntegerPlane made(const EdgePlane& plane) const;
  const IntegerPlane& exact(BspPlane plane);

  const BspPlanes& planes_;
  const BspFrame& frame_;
  std::array<int, 3> exponent_{};
  IntegerRow middle_;
  std::unordered_map<BspPlane, IntegerPlane> known_;
};

}  // namespace toccata
