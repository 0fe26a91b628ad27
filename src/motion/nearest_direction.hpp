#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "toccata/math/vec3.hpp"

// The point of a polygon at rest that is nearest to the origin, and the direction towards it. All is rounded: what is
// made of it proves itself.
namespace toccata {

struct NearestOfPolygon {
  Vec3 point;      ///< a mean of corners with weights that are not negative, rounded like any such
  Vec3 direction;  ///< towards it, nearly
};

inline NearestOfPolygon nearest_of_polygon_edge(const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double fraction = -dot(a, way) / dot(way, way);
  // A NaN, of a segment without length, is no fraction.
  const double f = fraction > 0 ? std::min(fraction, 1.0) : 0.0;
  const Vec3 point = (1 - f) * a + f * b;
  return {point, point};
}

inline NearestOfPolygon nearer_of_polygon(const NearestOfPolygon& a, const NearestOfPolygon& b) {
  return dot(b.point, b.point) < dot(a.point, a.point) ? b : a;
}

/// Inside, where the perpendicular from the origin meets it, and else on an edge. The normal is a better direction than
/// a point of which the digits have cancelled.
inline NearestOfPolygon nearest_of_polygon(const std::array<Vec3, 3>& q) {
  const auto& [a, b, c] = q;
  const Vec3 normal = cross(b - a, c - a);
  const double of_a = dot(cross(b, c), normal), of_b = dot(cross(c, a), normal), of_c = dot(cross(a, b), normal);
  const double sum = of_a + of_b + of_c;
  if (of_a >= 0 && of_b >= 0 && of_c >= 0 && sum > 0)
    return {(of_a * a + of_b * b + of_c * c) / sum, dot(normal, a) < 0 ? -normal : normal};
  return nearer_of_polygon(nearer_of_polygon(nearest_of_polygon_edge(a, b), nearest_of_polygon_edge(b, c)),
                           nearest_of_polygon_edge(c, a));
}

/// A parallelogram is two triangles.
inline NearestOfPolygon nearest_of_polygon(const std::array<Vec3, 4>& q) {
  return nearer_of_polygon(nearest_of_polygon(std::array{q[0], q[1], q[2]}),
                           nearest_of_polygon(std::array{q[0], q[2], q[3]}));
}

}  // namespace toccata
