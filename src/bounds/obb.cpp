#include "toccata/bounds/obb.hpp"

#include <array>

#include "bounds/frame.hpp"
#include "bounds/normals.hpp"
#include "bounds/point_clouds.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/separation.hpp"
#include "math/constants.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {
namespace {

/// Grown by what `contains` may be off by: for boxes that are known by their supports, and not by points it has seen.
Vec3 offset_outward(const Vec3& half) {
  const double slack = 0x1p-43 * largest_magnitude(half);
  return {rounded_up(half.x + slack), rounded_up(half.y + slack), rounded_up(half.z + slack)};
}

/// The box with these axes around whatever the function `support(direction, from)` bounds.
template <class Support>
Obb around(const Mat3& axes, const Vec3& near, const Support& support) {
  Vec3 middle_along, half;
  for (int axis = 0; axis < 3; ++axis)
    middle_along[axis] = 0.5 * support(axes[axis], near) - 0.5 * support(-axes[axis], near);
  const Vec3 centre = point_in_frame(axes, near, middle_along);
  // Anew from the centre, which rounding need not have left in the middle.
  for (int axis = 0; axis < 3; ++axis)
    half[axis] = std::max({0.0, support(axes[axis], centre), support(-axes[axis], centre)});
  half = offset_outward(half);
  if (!is_finite(centre) || !is_finite(half)) return {{}, {}, {infinity, infinity, infinity}};
  return {centre, axes, half};
}

const Obb& smaller(const Obb& a, const Obb& b) { return half_area(b) < half_area(a) ? b : a; }

std::array<Vec3, 8> corners_of(const Obb& box) {
  std::array<Vec3, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    const auto along = [&](unsigned axis) {
      const double half = box.half[static_cast<int>(axis)];
      return (i >> axis & 1U) != 0 ? half : -half;
    };
    corners[i] = point_in_frame(box.axes, box.centre, {along(0), along(1), along(2)});
  }
  return corners;
}

/// Principal axes of the corners; those of the world where the corners are out of range.
Mat3 common_axes(const Obb& a, const Obb& b) {
  std::vector<Vec3> corners;
  for (const Obb* box : {&a, &b})
    for (const Vec3& corner : corners_of(*box)) corners.push_back(corner);
  for (const Vec3& corner : corners)
    if (!(largest_magnitude(corner) <= greatest_fitted_coordinate)) return {};
  return principal_axes(corners).axes;
}

}  // namespace

Directions face_normals(const Obb& box) { return directions_of(box.axes); }

Obb fit_obb(std::span<const Vec3> points, const Mat3& axes) {
  const Aabb box = checked_box(points);
  if (is_empty(box)) return {};
  const Vec3 near = centre_of(box);
  Aabb along;
  for (const Vec3& p : points) {
    const Vec3 y = p - near;
    along = merge(along, Vec3{dot(axes[0], y), dot(axes[1], y), dot(axes[2], y)});
  }
  Obb fitted{points.size() == 1 ? near : point_in_frame(axes, near, centre_of(along)), axes, {}};
  for (const Vec3& p : points) fitted.half = larger(fitted.half, coordinate_bounds(axes, fitted.centre, p));
  return fitted;
}

template <>
Obb fit<Obb>(std::span<const Vec3> points) {
  return smaller(fit_obb(points, principal_axes(points).axes), fit_obb(points, {}));
}

template <>
Obb fit<Obb>(std::span<const Triangle> triangles) {
  const std::vector<Vec3> corners = corners_of(triangles);
  return smaller(fit_obb(corners, principal_axes(triangles).axes), fit_obb(corners, {}));
}

double support_bound(const Obb& box, const Vec3& direction, const Vec3& from) {
  if (is_empty(box)) return -infinity;
  UpperSum sum;
  sum.add(direction, box.centre - from);
  for (int axis = 0; axis < 3; ++axis) {
    UpperSum along;
    along.add(direction, box.axes[axis]);
    sum.add(along.magnitude_bound(), box.half[axis]);
  }
  return sum.bound();
}

Vec3 farthest_point(const Obb& box, const Vec3& direction) {
  const auto along = [&](int axis) { return dot(direction, box.axes[axis]) < 0 ? -box.half[axis] : box.half[axis]; };
  return point_in_frame(box.axes, box.centre, {along(0), along(1), along(2)});
}

Obb merge(const Obb& a, const Obb& b) {
  if (is_empty(a) || is_empty(b)) return is_empty(a) ? b : a;
  const auto both = [&](const Vec3& direction, const Vec3& from) {
    return std::max(support_bound(a, direction, from), support_bound(b, direction, from));
  };
  const Obb as_a = around(a.axes, a.centre, both), as_b = around(b.axes, b.centre, both);
  return smaller(smaller(as_a, as_b), around(common_axes(a, b), a.centre, both));
}

// In the coordinates of a, with R_ij = a_i · b_j and T the way from centre to centre; across edges i and j the
// direction is a_i × b_j, not made unit, so that nearly parallel edges need no exception: both sides are then nearly
// zero.
//
// What the sums are off by: the axes are orthonormal to within 2⁻⁴⁶, so each of the at most six terms is off by a few
// times that, relative to T and to the half extents, and rounding adds less. The pad is 2⁻⁴² of all these together.
bool overlap(const Obb& a, const Obb& b) {
  if (is_empty(a) || is_empty(b)) return false;
  const Vec3 way = b.centre - a.centre;
  Mat3 r, magnitude;
  Vec3 t;
  for (int i = 0; i < 3; ++i) {
    t[i] = dot(a.axes[i], way);
    for (int j = 0; j < 3; ++j) magnitude[i][j] = std::fabs(r[i][j] = dot(a.axes[i], b.axes[j]));
  }
  const auto sum = [](const Vec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); };
  const double pad = 0x1p-42 * (sum(way) + sum(a.half) + sum(b.half)) + 0x1p-1060;
  const auto parted = [pad](double between, double reach) { return std::fabs(between) > reach + pad; };
  for (int i = 0; i < 3; ++i) {
    if (parted(t[i], a.half[i] + dot(magnitude[i], b.half))) return false;
    if (parted(dot(b.axes[i], way), b.half[i] + dot(magnitude.column(i), a.half))) return false;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double reach_a = a.half[i1] * magnitude[i2][j] + a.half[i2] * magnitude[i1][j];
      const double reach_b = b.half[j1] * magnitude[i][j2] + b.half[j2] * magnitude[i][j1];
      if (parted(t[i2] * r[i1][j] - t[i1] * r[i2][j], reach_a + reach_b)) return false;
    }
  return true;
}

bool contains(const Obb& box, const Vec3& point) {
  if (is_empty(box)) return false;
  const Vec3 bounds = coordinate_bounds(box.axes, box.centre, point);
  return bounds.x <= box.half.x && bounds.y <= box.half.y && bounds.z <= box.half.z;
}

Obb posed(const Obb& box, const Pose& pose) {
  if (is_empty(box)) return {};
  const Pose turn{pose.linear, {}};
  const Mat3 axes = orthonormal_axes(transform(turn, box.axes[0]), transform(turn, box.axes[1]));
  return around(axes, transform(pose, box.centre), PosedSupport(box, pose));
}

Aabb box_around(const Obb& box) { return box_by_supports(box); }

double measure(const Obb& box) { return is_empty(box) ? 0 : 8 * box.half.x * box.half.y * box.half.z; }
double half_area(const Obb& box) {
  const Vec3& half = box.half;
  return is_empty(box) ? 0 : 4 * ((half.x * half.y + half.y * half.z) + half.z * half.x);
}
double surface_area(const Obb& box) { return 2 * half_area(box); }

TOCCATA_INSTANTIATE_VOLUME(Obb);

}  // namespace toccata
