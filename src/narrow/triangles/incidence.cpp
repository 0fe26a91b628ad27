#include "narrow/triangles/incidence.hpp"

namespace toccata {
namespace {

bool strictly_opposite(Sign s, Sign t) { return s * t == Sign::negative; }

bool same_and_not_zero(Sign r, Sign s, Sign t) { return r != Sign::zero && r == s && s == t; }

/// The axis along which a rounded normal is longest: the most likely to show the triangle without exact arithmetic.
int likely_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  return x > y && x > z ? 0 : y > z ? 1 : 2;
}

}  // namespace

Sign orient_without(int axis, const Vec3& a, const Vec3& b, const Vec3& c) {
  return orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis));
}

std::optional<int> axis_that_shows(const Vec3& a, const Vec3& b, const Vec3& c) {
  const int first = likely_axis(a, b, c);
  for (int i = 0; i < 3; ++i) {
    const int axis = (first + i) % 3;
    if (orient_without(axis, a, b, c) != Sign::zero) return axis;
  }
  return std::nullopt;
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) { return !axis_that_shows(a, b, c); }

bool in_open_segment(const Vec3& x, const Vec3& p, const Vec3& q) {
  const bool forward = lexicographically_less(p, x) && lexicographically_less(x, q);
  const bool backward = lexicographically_less(q, x) && lexicographically_less(x, p);
  return (forward || backward) && collinear(x, p, q);
}

bool in_open_triangle(const Vec3& x, const Triangle& t) {
  if (orient3d(t[0], t[1], t[2], x) != Sign::zero) return false;
  const std::optional<int> axis = axis_that_shows(t[0], t[1], t[2]);
  return axis && same_and_not_zero(orient_without(*axis, t[0], t[1], x), orient_without(*axis, t[1], t[2], x),
                                   orient_without(*axis, t[2], t[0], x));
}

bool open_segments_cross(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  if (orient3d(p, q, r, s) != Sign::zero) return false;
  const std::optional<int> axis = axis_that_shows(p, q, r);  // none: an end of rs lies on the line pq
  return axis && strictly_opposite(orient_without(*axis, p, q, r), orient_without(*axis, p, q, s)) &&
         strictly_opposite(orient_without(*axis, r, s, p), orient_without(*axis, r, s, q));
}

bool open_segment_pierces(const Vec3& p, const Vec3& q, const Triangle& t) {
  return strictly_opposite(orient3d(t[0], t[1], t[2], p), orient3d(t[0], t[1], t[2], q)) &&
         same_and_not_zero(orient3d(p, q, t[0], t[1]), orient3d(p, q, t[1], t[2]), orient3d(p, q, t[2], t[0]));
}

}  // namespace toccata
