#include "toccata/narrow/triangle_triangle.hpp"

#include "narrow/triangles/coplanar_intersection.hpp"
#include "narrow/triangles/feature_intersection.hpp"
#include "narrow/triangles/intersection_from_points.hpp"
#include "narrow/triangles/plane_intervals.hpp"

namespace toccata {
namespace {

/// Where two intervals on the line of both planes meet. A triangle cut in one point has start equal to end.
Intersection intersection_of_intervals(const PlaneInterval& a, const PlaneInterval& b) {
  // b is ordered against the direction that `order` goes by.
  const IntervalEnd &first_b = b.end, &last_b = b.start;
  const Sign a_starts_then_b_ends = order(a.start, last_b);
  if (a_starts_then_b_ends == Sign::negative) return {};
  const Sign a_ends_then_b_starts = order(a.end, first_b);
  if (a_ends_then_b_starts == Sign::positive) return {};
  const auto only = [](const Feature& on_a, const Feature& on_b) {
    const IntersectionPoint point{on_a, on_b};
    return intersection_from_points({&point, 1}, {});
  };
  if (a_starts_then_b_ends == Sign::zero) return only(a.start.feature, last_b.feature);
  if (a_ends_then_b_starts == Sign::zero) return only(a.end.feature, first_b.feature);
  if (a.carrier.kind == FeatureKind::vertex) return only(a.carrier, b.carrier);
  if (b.carrier.kind == FeatureKind::vertex) return only(a.carrier, b.carrier);
  const auto end_where = [&](Sign b_is_inside, const IntervalEnd& end_a,
                             const IntervalEnd& end_b) -> IntersectionPoint {
    if (b_is_inside == Sign::zero) return {end_a.feature, end_b.feature};
    return b_is_inside == Sign::positive ? IntersectionPoint{a.carrier, end_b.feature}
                                         : IntersectionPoint{end_a.feature, b.carrier};
  };
  const std::array<IntersectionPoint, 2> ends{end_where(order(a.start, first_b), a.start, first_b),
                                              end_where(-order(a.end, last_b), a.end, last_b)};
  return intersection_from_points(ends, {});
}

bool both_have_area(const Triangle& a, const Triangle& b) {
  return features_of(a).whole().kind == FeatureKind::face && features_of(b).whole().kind == FeatureKind::face;
}

}  // namespace

bool overlap_by_penetration(const Triangle& a, const Triangle& b) {
  const MutualSides sides = mutual_sides(a, b);
  if (sides.apart) return false;
  if (sides.flat) return both_have_area(a, b) ? coplanar_overlap(a, b) : features_overlap(a, b);
  const PlaneInterval in_a = plane_interval(a, sides.of_a), in_b = plane_interval(b, sides.of_b);
  return order(in_a.start, in_b.start) != Sign::negative && order(in_a.end, in_b.end) != Sign::positive;
}

bool overlap(const Triangle& a, const Triangle& b) { return overlap_by_penetration(a, b); }

Intersection intersect(const Triangle& a, const Triangle& b) {
  const MutualSides sides = mutual_sides(a, b);
  if (sides.apart) return {};
  if (sides.flat) return both_have_area(a, b) ? coplanar_intersection(a, b) : feature_intersection(a, b);
  return intersection_of_intervals(plane_interval(a, sides.of_a), plane_interval(b, sides.of_b));
}

}  // namespace toccata
