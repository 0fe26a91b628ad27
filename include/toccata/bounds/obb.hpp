#pragma once

#include <span>

#include "toccata/bounds/volume.hpp"
#include "toccata/math/mat3.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// An oriented box: all centre + Σ s_i · axis_i with |s_i| ≤ half_i, in real numbers. The axes are the rows, of unit
/// length and at right angles to within 2⁻⁴⁶, as `orthonormal_axes` makes them. Empty while a half extent is negative.
///
/// Two are parted along 15 directions: three normals of each, and nine across an edge of each (S. Gottschalk, M. C.
/// Lin, D. Manocha, "OBBTree: a hierarchical structure for rapid interference detection", 1996). Boxes along the
/// world's axes around them, `box_around`, settle the easy cases for less where they are kept.
struct Obb {
  static constexpr std::string_view name = "obb";
  static constexpr double microseconds = 3;

  Vec3 centre;
  Mat3 axes;
  Vec3 half{-1, -1, -1};
  friend constexpr bool operator==(const Obb&, const Obb&) = default;
};

/// Along the principal axes, or along those of the world where that box has less surface; from the farthest points.
template <>
Obb fit<Obb>(std::span<const Vec3> points);
template <>
Obb fit<Obb>(std::span<const Triangle> triangles);
/// Along given axes.
[[nodiscard]] Obb fit_obb(std::span<const Vec3> points, const Mat3& axes);

[[nodiscard]] constexpr bool is_empty(const Obb& box) { return box.half.x < 0 || box.half.y < 0 || box.half.z < 0; }
[[nodiscard]] double support_bound(const Obb& box, const Vec3& direction, const Vec3& from);
[[nodiscard]] Vec3 farthest_point(const Obb& box, const Vec3& direction);
[[nodiscard]] inline Vec3 middle(const Obb& box) { return box.centre; }

/// Makes three boxes around both, with the axes of `a`, those of `b`, and the principal axes of all corners, and
/// returns the one with the least surface.
[[nodiscard]] Obb merge(const Obb& a, const Obb& b);
[[nodiscard]] bool contains(const Obb& box, const Vec3& point);
/// Compares the two along the 15 directions that can separate boxes.
[[nodiscard]] bool overlap(const Obb& a, const Obb& b);
/// A rotation turns it as it is, but for rounding; other poses are followed by a box around the image.
[[nodiscard]] Obb posed(const Obb& box, const Pose& pose);
[[nodiscard]] Aabb box_around(const Obb& box);
[[nodiscard]] double measure(const Obb& box);
[[nodiscard]] double surface_area(const Obb& box);
[[nodiscard]] double half_area(const Obb& box);

/// How points, or the surface of triangles, are spread: the mean, the principal axes as rows (unit, right-handed, by
/// descending spread), and the standard deviation along each, in the units of the points.
struct PrincipalAxes {
  Vec3 mean;
  Mat3 axes;
  Vec3 spread;
};

/// Every point counts alike. No points: the coordinate axes at the origin. Throws Error when a coordinate is not finite
/// or of magnitude above 2^1000.
[[nodiscard]] PrincipalAxes principal_axes(std::span<const Vec3> points);

/// Every piece of surface counts alike, so that it does not matter how finely which part is cut into triangles: with
/// areas A, centroids m and corners p, q, r of each triangle, the covariance is
/// Σ A/12 (9 m mᵀ + p pᵀ + q qᵀ + r rᵀ) / ΣA − μ μᵀ, where μ = Σ A m / ΣA (S. Gottschalk, M. C. Lin, D. Manocha,
/// "OBBTree: a hierarchical structure for rapid interference detection", 1996, as corrected by their erratum; the
/// formula in print is wrong). Triangles without any area: their vertices count. Errors as above.
[[nodiscard]] PrincipalAxes principal_axes(std::span<const Triangle> triangles);

}  // namespace toccata
