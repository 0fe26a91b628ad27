#pragma once

#include "bounds/upper_sum.hpp"
#include "toccata/math/mat3.hpp"

// Points in the coordinates s of a frame: point = centre + Σ s_i axis_i, with axes that are orthonormal to within 2⁻⁴⁶.
namespace toccata {

/// No less than any |s_i| of a point whose |axis_i · (point − centre)| are at most these.
///
/// With A the matrix of the axes and y = point − centre, y = Aᵀs and Ay = AAᵀs = (1 + E)s, where the row sums of |E|
/// are below 2⁻⁴⁶. So s differs from Ay by at most 2⁻⁴⁶ / (1 − 2⁻⁴⁶) of the largest |Ay|.
inline Vec3 coordinate_bounds(const Vec3& along_axes) {
  const double skew = 0x1p-45 * largest_magnitude(along_axes);
  return {rounded_up(along_axes.x + skew), rounded_up(along_axes.y + skew), rounded_up(along_axes.z + skew)};
}

/// No less than any |s_i| of a point.
inline Vec3 coordinate_bounds(const Mat3& axes, const Vec3& centre, const Vec3& point) {
  const Vec3 from_centre = point - centre;
  if (from_centre == Vec3{}) return {};
  Vec3 along;
  for (int axis = 0; axis < 3; ++axis) {
    UpperSum sum;
    sum.add(axes[axis], from_centre);
    along[axis] = sum.magnitude_bound();
  }
  return coordinate_bounds(along);
}

/// The point with given coordinates, rounded.
inline Vec3 point_in_frame(const Mat3& axes, const Vec3& centre, const Vec3& s) {
  return centre + ((s.x * axes[0] + s.y * axes[1]) + s.z * axes[2]);
}

inline Vec3 larger(const Vec3& a, const Vec3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

}  // namespace toccata
