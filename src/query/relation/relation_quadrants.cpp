#include "query/relation/relation_quadrants.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "query/inside/inside_winding.hpp"

namespace toccata {
namespace {

/// Shares of the triangles' size: small enough for what is near by, and then for needles and acute angles.
constexpr double quadrant_distances[] = {0x1p-8, 0x1p-16, 0x1p-28};

/// Where the edge passes through the plane of a triangle, but for rounding.
Vec3 pierced(const Triangle& of_edge, int edge, const Triangle& plane) {
  const Vec3 &from = of_edge[edge], &to = of_edge[(edge + 1) % 3];
  const Vec3 normal = cross(plane[1] - plane[0], plane[2] - plane[0]);
  const double start = dot(normal, from - plane[0]), end = dot(normal, to - plane[0]);
  const double part = start == end ? 0.5 : start / (start - end);
  return from + std::clamp(part, 0.0, 1.0) * (to - from);
}

Vec3 near_point(const IntersectionPoint& point, const Triangle& a, const Triangle& b) {
  if (point.on_a.kind == FeatureKind::vertex) return a[point.on_a.index];
  if (point.on_b.kind == FeatureKind::vertex) return b[point.on_b.index];
  return point.on_a.kind == FeatureKind::edge ? pierced(a, point.on_a.index, b) : pierced(b, point.on_b.index, a);
}

Vec3 middle_of(const Intersection& intersection, const Triangle& a, const Triangle& b) {
  Vec3 sum;
  for (std::size_t i = 0; i < intersection.count; ++i) sum = sum + near_point(intersection.points[i], a, b);
  return (1.0 / intersection.count) * sum;
}

Vec3 unit_normal_or_zero(const Triangle& t) { return unit_or_zero(cross(t[1] - t[0], t[2] - t[0])); }

double size_of(const Triangle& t) { return std::max(largest_magnitude(t[1] - t[0]), largest_magnitude(t[2] - t[0])); }

RegionsSeen region_at(const SolidPair& pair, const Vec3& point) {
  const ExactPoint exact(point);
  const bool in_a = wind_along(pair.a, exact, 0).ahead != 0, in_b = wind_along(pair.b, exact, 0).ahead != 0;
  return {in_a && in_b, in_a && !in_b, in_b && !in_a};
}

}  // namespace

RegionsSeen sample_quadrants(const SolidPair& pair, const Triangle& a, const Triangle& b,
                             const Intersection& intersection) {
  RegionsSeen seen;
  if (intersection.count == 0) return seen;
  const Vec3 middle = middle_of(intersection, a, b), of_a = unit_normal_or_zero(a), of_b = unit_normal_or_zero(b);
  // Along either plane, away from the other one.
  const Vec3 beside_a = unit_or_zero(of_a - dot(of_a, of_b) * of_b);
  const Vec3 beside_b = unit_or_zero(of_b - dot(of_a, of_b) * of_a);
  const double size = std::min(size_of(a), size_of(b));
  for (const double part : quadrant_distances)
    for (const int side_a : {-1, 1})
      for (const int side_b : {-1, 1}) {
        const Vec3 point = middle + (part * size) * (side_a * beside_a + side_b * beside_b);
        if (is_finite(point)) seen = seen | region_at(pair, point);
        if (seen.all()) return seen;
      }
  return seen;
}

}  // namespace toccata
