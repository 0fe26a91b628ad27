#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"

// What the proof of axial_box.cpp takes for granted of a shape that is round about its axis, as u = 2⁻⁵³.
namespace toccata {

/// Points of round sides are drawn in by this part, so that they are of the shape whatever was rounded: t (3 − t²) / 2
/// is no more than 1, and off by 3 u for t, 4 u for the factors, and u for the point; towards a tip, how wide it is by
/// 3 u.
inline constexpr double axial_drawn_in = 13 * unit_roundoff;

/// A point of the shape, in its own frame: at the height of the foot, and as far from the axis, in the direction (x, y)
/// of length 1, which may be rounded.
template <AxialKind Kind>
[[nodiscard]] Vec3 drawn_in_foot(const Vec3& half, const AxialFoot& foot, double x, double y) {
  const double reach = Kind::radius_at(half, foot.up);
  if (!(reach > 0)) return {0, 0, foot.up};
  // Next to a tip both are hardly more than rounding.
  const double part = std::min(foot.out / reach, 1.0);
  const Vec3 v{part * x, part * y, 0};
  // No more than the quotient by the length, for no length.
  const double squared = dot(v, v), less = squared > 1 - 0x1p-30 ? 1.5 - 0.5 * squared : 1;
  const double drawn = (1 - axial_drawn_in) * less * reach;
  return {drawn * v.x, drawn * v.y, foot.up};
}

/// What the shape reaches beyond one of its points p, against a direction whose products with the columns of its pose
/// are n.
template <AxialKind Kind>
[[nodiscard]] double beyond_axial(const Vec3& half, const Vec3& p, const Vec3& n) {
  const double round = n.x * p.x + n.y * p.y, rim = half.x * std::sqrt(n.x * n.x + n.y * n.y) + round;
  return Kind::beyond(half, rim, round, n.z, p.z);
}

/// What this, of a radius r and a half height h, and what a box reaches beyond one of its points, of half extents of
/// the length e, are off by together along a direction of the length L = 1.
///
/// n: 3 u L each, so 4.3 u L of the first two. The rim 4.3 r for each of two uses of n, 3.5 + 2 of the length and the
/// product, 2 of the sum; of the axis 3 · 2 h, 4 h of the differences and products, 2 h and 2 r of sums: in all u L
/// (18.1 r + 12.1 h), the cylinder less. The box adds 4 u for each height, of corners no farther than 2.1 e: u L 8.4 e;
/// where there are steps from its corner, their 3 u e, 3 u for their product, and 3 u e of the difference: u L 9.1 e
/// more.
[[nodiscard]] inline double rounding_beyond(double r, double h, double e, bool is_corner) {
  return unit_roundoff * ((20.5 * r + 13.7 * h) + (is_corner ? 9.5 : 20) * e);
}

}  // namespace toccata
