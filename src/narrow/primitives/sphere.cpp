#include "toccata/narrow/primitives.hpp"

#include "math/filter.hpp"
#include "math/wide_integer.hpp"
#include "narrow/convex/convex_of.hpp"
#include "narrow/primitives/closed_forms.hpp"

namespace toccata {
namespace {

/// The formula's answer, or that of the search.
template <class A, class B>
bool decided(Nearness nearness, const A& a, const B& b) {
  if (nearness != Nearness::unknown) return nearness == Nearness::meet;
  return overlap(convex_of(a), convex_of(b));
}

/// The sign of (radius · |normal|)² − height², for the point's height over the plane's unscaled normal.
Sign reach_beyond_plane(const Plane& plane, const Vec3& point, double radius) {
  const std::array points{plane.a(), plane.b(), plane.c(), point};
  const int unit = std::min(common_exponent(points), common_exponent({radius}));
  const IntegerVector a = scaled_wide(plane.a(), unit);
  const IntegerVector normal = cross(scaled_wide(plane.b(), unit) - a, scaled_wide(plane.c(), unit) - a);
  const WideInteger height = dot(normal, scaled_wide(point, unit) - a), reach = scaled_wide(radius, unit);
  return static_cast<Sign>(WideInteger(reach * reach * dot(normal, normal) - height * height).sign());
}

}  // namespace

bool overlap(const PosedSphere& a, const PosedSphere& b) {
  return decided(nearness_of_points(a.centre, b.centre, a.radius + b.radius), a, b);
}

bool overlap(const PosedSphere& a, const Triangle& b) {
  return decided(nearness_of_point_triangle(a.centre, b, a.radius), a, b);
}

bool overlap(const PosedSphere& a, const PosedBox& b) {
  return decided(nearness_of_point_box(a.centre, b, a.radius), a, b);
}

bool overlap(const PosedSphere& a, const PosedCapsule& b) {
  return decided(nearness_of_point_segment(a.centre, b.start, b.end, a.radius + b.radius), a, b);
}

bool overlap(const PosedSphere& a, const Plane& b) { return overlap(convex_of(a), b); }

bool overlap(const PosedPolytope& a, const Plane& b) {
  const Sign first = side(b, a.vertex(0));
  for (Index i = 1; i < a.vertex_count(); ++i)
    if (side(b, a.vertex(i)) != first) return true;
  if (first == Sign::zero) return true;
  if (a.radius() == 0) return false;
  for (Index i = 0; i < a.vertex_count(); ++i)
    if (reach_beyond_plane(b, a.vertex(i), a.radius()) != Sign::negative) return true;
  return false;
}

bool overlap(const PosedCapsule& a, const PosedCapsule& b) {
  return decided(nearness_of_segments(a.start, a.end, b.start, b.end, a.radius + b.radius), a, b);
}

bool overlap(const PosedCapsule& a, const Segment& b) {
  return decided(nearness_of_segments(a.start, a.end, b.start(), b.end(), a.radius), a, b);
}

bool overlap(const PosedCapsule& a, const Triangle& b) { return overlap(convex_of(a), convex_of(b)); }
bool overlap(const PosedCapsule& a, const PosedBox& b) { return overlap(convex_of(a), convex_of(b)); }

Distance distance(const PosedCapsule& a, const Triangle& b) { return distance(convex_of(a), convex_of(b)); }

}  // namespace toccata
