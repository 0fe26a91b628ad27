#include "query/inside/inside_point.hpp"

#include <cmath>
#include <utility>

#include "math/constants.hpp"
#include "math/exact.hpp"
#include "query/inside/enclose.hpp"
#include "query/meshes/posed_mesh.hpp"

namespace toccata {
namespace {

Interval as_interval(double value) { return {value, value}; }

/// The projected coordinates of (axis + 1) % 3 and (axis + 2) % 3 are both doubles.
bool projects_to_doubles(const ExactPoint& p, int axis) {
  return p.is_double((axis + 1) % 3) && p.is_double((axis + 2) % 3);
}

Interval orient2d_interval(const Vec2& a, const Vec2& b, const Interval& px, const Interval& py) {
  const Interval ux = as_interval(b.x) - as_interval(a.x), uy = as_interval(b.y) - as_interval(a.y);
  return ux * (py - as_interval(a.y)) - uy * (px - as_interval(a.x));
}

Interval orient3d_interval(const Triangle& t, const ExactPoint& p) {
  const auto difference = [&](int vertex, int axis) { return as_interval(t[vertex][axis]) - as_interval(t[0][axis]); };
  const auto term = [&](int axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Interval normal = difference(1, i) * difference(2, j) - difference(1, j) * difference(2, i);
    return normal * (p.around(axis) - as_interval(t[0][axis]));
  };
  return term(0) + term(1) + term(2);
}

/// The point lies on the closed segment, which may be a point.
bool lies_on_segment(const ExactPoint& p, const Vec3& a, const Vec3& b) {
  for (int axis = 0; axis < 3; ++axis) {
    const Rational x = p.rational()[axis];
    if (x < to_rational(std::min(a[axis], b[axis])) || x > to_rational(std::max(a[axis], b[axis]))) return false;
    if (orient2d(a, b, p, axis) != Sign::zero) return false;
  }
  return true;
}

/// Whether a point is in the triangle, in whose plane it lies; the projection of the triangle along `axis` has area.
bool projects_into(const ExactPoint& p, const Triangle& t, int axis) {
  bool left = false, right = false;
  for (int i = 0; i < 3; ++i) {
    const Sign side = orient2d(t[i], t[(i + 1) % 3], p, axis);
    left |= side == Sign::positive;
    right |= side == Sign::negative;
  }
  return !(left && right);
}

}  // namespace

Interval enclose(const Rational& value) {
  const double nearest = nearest_double(value);
  if (std::isfinite(nearest) && to_rational(nearest) == value) return {nearest, nearest};
  return {std::nextafter(nearest, -infinity), std::nextafter(nearest, infinity)};
}

ExactPoint::ExactPoint(const Vec3& point) : box_{point, point} {}

ExactPoint::ExactPoint(RationalPoint point) : rational_(std::make_shared<const RationalPoint>(std::move(point))) {
  for (int axis = 0; axis < 3; ++axis) {
    const Interval enclosure = enclose((*rational_)[axis]);
    box_.lower[axis] = enclosure.lower;
    box_.upper[axis] = enclosure.upper;
  }
}

RationalPoint ExactPoint::rational() const { return rational_ ? *rational_ : to_rational(box_.lower); }

Sign orient2d(const Vec3& a, const Vec3& b, const ExactPoint& p, int axis) {
  const Vec2 a2 = drop_axis(a, axis), b2 = drop_axis(b, axis);
  if (projects_to_doubles(p, axis)) return orient2d(a2, b2, drop_axis(p.box().lower, axis));
  const Interval filter = orient2d_interval(a2, b2, p.around((axis + 1) % 3), p.around((axis + 2) % 3));
  if (certainly_positive(filter)) return Sign::positive;
  if (certainly_negative(filter)) return Sign::negative;
  return orient2d(to_rational(a2), to_rational(b2), drop_axis(p.rational(), axis));
}

Sign orient3d(const Triangle& t, const ExactPoint& p) {
  if (p.box().lower == p.box().upper) return orient3d(t[0], t[1], t[2], p.box().lower);
  const Interval filter = orient3d_interval(t, p);
  if (certainly_positive(filter)) return Sign::positive;
  if (certainly_negative(filter)) return Sign::negative;
  return orient3d(to_rational(t[0]), to_rational(t[1]), to_rational(t[2]), p.rational());
}

bool lies_on(const ExactPoint& p, const Triangle& t) {
  if (!overlap(p.box(), box_of(t)) || orient3d(t, p) != Sign::zero) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (projected_orientation(t, axis) != Sign::zero) return projects_into(p, t, axis);
  for (int i = 0; i < 3; ++i)
    if (lies_on_segment(p, t[i], t[(i + 1) % 3])) return true;
  return false;
}

Sign projected_orientation(const Triangle& t, int axis) {
  return orient2d(drop_axis(t[0], axis), drop_axis(t[1], axis), drop_axis(t[2], axis));
}

}  // namespace toccata
