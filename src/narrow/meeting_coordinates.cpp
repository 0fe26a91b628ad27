#include "math/exact.hpp"
#include "narrow/triangle_features.hpp"

namespace toccata {
namespace {

// The functions below take features that meet in a single point, so no denominator is zero.

RationalPoint point_between(const RationalPoint& p, const RationalPoint& q, const Rational& share) {
  return p + share * (q - p);
}

/// Where the line pq meets the plane of `t`.
RationalPoint line_and_plane(const Vec3& p, const Vec3& q, const Triangle& t) {
  const RationalPoint origin = to_rational(t[0]), from = to_rational(p), to = to_rational(q);
  const RationalPoint normal = cross(to_rational(t[1]) - origin, to_rational(t[2]) - origin);
  const Rational height = dot(normal, from - origin);
  return point_between(from, to, height / (height - dot(normal, to - origin)));
}

/// Where the lines pq and rs, of one plane and not parallel, meet.
RationalPoint line_and_line(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const RationalPoint from = to_rational(p), to = to_rational(q);
  const RationalPoint other_from = to_rational(r), other = to_rational(s) - other_from;
  const RationalPoint way = cross(other_from - from, other), whole = cross(to - from, other);
  const int axis = whole.x != 0 ? 0 : whole.y != 0 ? 1 : 2;
  return point_between(from, to, way[axis] / whole[axis]);
}

/// Makes −0 to 0: the two are one value, and a shared vertex may be written with either.
Vec3 with_positive_zeros(const Vec3& v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

Vec3 coordinates_of(const MeetingPoint& point, const Triangle& a, const Triangle& b) {
  const auto [on_a, on_b] = point;
  if (on_a.kind == FeatureKind::vertex) return with_positive_zeros(a[on_a.index]);
  if (on_b.kind == FeatureKind::vertex) return with_positive_zeros(b[on_b.index]);
  const Vec3 &start_a = edge_start(a, on_a.index), &end_a = edge_end(a, on_a.index);
  const Vec3 &start_b = edge_start(b, on_b.index), &end_b = edge_end(b, on_b.index);
  if (on_b.kind == FeatureKind::face) return nearest_doubles(line_and_plane(start_a, end_a, b));
  if (on_a.kind == FeatureKind::face) return nearest_doubles(line_and_plane(start_b, end_b, a));
  return nearest_doubles(line_and_line(start_a, end_a, start_b, end_b));
}

}  // namespace

MeetingCoordinates coordinates(const Meeting& m, const Triangle& a, const Triangle& b) {
  MeetingCoordinates result;
  result.count = m.count;
  for (std::size_t i = 0; i < m.count; ++i) result.points[i] = coordinates_of(m.points[i], a, b);
  return result;
}

}  // namespace toccata
