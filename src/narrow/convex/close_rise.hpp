#pragma once

#include "math/vec3_measures.hpp"
#include "toccata/math/pose.hpp"

// Bounds of heights. Let u = 2^-53. In its own frame a vertex x has the height h = fl(fl(Rᵀd) · x), off by less than
// 6.01u Σ |d_i||R_ij||x_j| from d · Rx, and the world vertex is off by less than 4.01u (Σ |R_ij||x_j| + |t_i|) from
// Rx + t; so h + d · t is within 10.1u Σ |d_i|(Σ |R_ij||x_j| + |t_i|) of the height of the world vertex. With 32u in
// place of 10.1u the few roundings of the bounds themselves and of their comparison are covered. For |d_i| its greatest
// is taken. A direction of which each coordinate is off by the slack s adds s times the same sum. Underflow: a product
// of Rᵀd loses at most 2^-1074, times |x_j|; each of those that make a height as much; and those that make a world
// vertex, times |d_i| ≤ 2^300.
namespace toccata {

inline constexpr double height_rounding = 0x1p-48;
inline constexpr double lost_per_coordinate = 0x1p-1000;
inline constexpr double lost_per_height = 0x1p-700;

/// What each coordinate of a world vertex lets its height along a direction be off by, of which each coordinate is
/// known to within `slack`.
inline double height_spread(const Vec3& direction, double slack) {
  return height_rounding * largest_magnitude(direction) + slack;
}

/// `SupportSearch::close` finds no vertex that is higher than the given one by more than this, where a height is the
/// product in doubles with the direction turned into the shape's own frame; `extent` is the greatest magnitude of a
/// coordinate there.
///
/// With M = Σ |R_ij| extent + Σ |t_i|, the depth of a vertex is less than its height by spread · M at most, and the
/// bound is more than the height of the given vertex by 3 spread · M. As the spread is 32u of the direction, the
/// roundings of depths, of the bound and of either world vertex add less than 1 spread · M, and those of a height in
/// the shape's own frame half of one.
inline double most_close_rise(const Pose& pose, double extent, double spread) {
  const Mat3& r = pose.linear;
  const double stretch = (sum_of_magnitudes(r[0]) + sum_of_magnitudes(r[1])) + sum_of_magnitudes(r[2]);
  const double most = 8 * spread * (stretch * extent + sum_of_magnitudes(pose.offset));
  return most + 8 * (lost_per_height + 3 * lost_per_coordinate * extent);
}

}  // namespace toccata
