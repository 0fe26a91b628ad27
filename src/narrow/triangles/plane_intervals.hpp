#pragma once

#include "narrow/triangles/plane_sides.hpp"
#include "narrow/triangles/triangle_features.hpp"

namespace toccata {

// Two triangles with area whose planes cross in a line L, each with a vertex on or on both sides of the other's plane.
// Each then has an interval in common with L. Ends are compared along L by a single orient3d and no coordinates.

/// One end of the interval in which a triangle meets the other's plane: the feature that lies there, and a line in the
/// triangle through the end and across L, from the negative to the positive side of the other plane. Its two points are
/// vertices of the triangle, which must outlive it.
struct IntervalEnd {
  Feature feature;
  const Vec3* below;
  const Vec3* above;
};

/// Ordered along (normal of the triangle) × (normal of the other).
struct PlaneInterval {
  IntervalEnd start;
  IntervalEnd end;
  Feature carrier;  ///< the smallest feature that contains the interval
};

/// The interval of a triangle whose vertices lie on these sides of the other's plane: not all zero, not all strictly on
/// one side.
[[nodiscard]] PlaneInterval plane_interval(const Triangle& t, const PlaneSides& sides);

/// Positive when the end of b comes after the end of a along (normal of a) × (normal of b), zero when they are the same
/// point.
///
/// Let u and v be the directions of the two lines, n_a and n_b the normals, d = n_a × n_b, and t·d the way from the end
/// of a to that of b. The determinant is a positive multiple of det(u, t·d, v) = −t d·(u × v), and
/// d·(u × v) = (n_a·u)(n_b·v) − (n_a·v)(n_b·u) = −(n_a·v)(n_b·u) < 0, because u lies in the plane of a, v in that of b,
/// and both go to the positive side of the other.
[[nodiscard]] inline Sign order(const IntervalEnd& of_a, const IntervalEnd& of_b) {
  return orient3d(*of_a.below, *of_a.above, *of_b.below, *of_b.above);
}

}  // namespace toccata
