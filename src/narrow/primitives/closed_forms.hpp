#pragma once

#include <algorithm>
#include <array>

#include "narrow/primitives/nearness.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/posed_shapes.hpp"
#include "toccata/shapes/primitives.hpp"

// Formulas for pairs of simple cores, each grown by a radius; `reach` is the sum of the radii. They answer in nearly
// all cases; the rest is left to the search and to exact arithmetic.
// After C. Ericson, "Real-Time Collision Detection", 2005, sections 5.1.2 to 5.1.9; the proofs are ours.
namespace toccata {

inline double least_of(double a, double b) { return a < b ? a : b; }

/// The least product with d of the points p + [0, 1] · edge.
inline double least_along(const Vec3& d, const Vec3& p, const Vec3& edge) {
  return dot(p, d) + least_of(0, dot(edge, d));
}

struct SegmentWeights {
  double s = 0;
  double t = 0;
};

/// The weights of the nearest points p + s · u and q + t · v, given the difference p − q; section 5.1.9.
inline SegmentWeights nearest_weights_of_segments(const Vec3& difference, const Vec3& u, const Vec3& v) {
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
  const double along_u = dot(u, difference), along_v = dot(v, difference);
  const double determinant = uu * vv - uv * uv;
  // Parallel or nearly: any s will do, and that of the first end is taken. A segment without length has 0 / 0.
  double s = determinant > 0 ? clamped((uv * along_v - along_u * vv) / determinant, 0, 1) : 0;
  double t = (uv * s + along_v) / vv;
  if (!(t > 0 && t < 1)) {
    t = t >= 1 ? 1 : 0;
    s = clamped((uv * t - along_u) / uu, 0, 1);
  }
  return {s, t};
}

inline Nearness nearness_of_points(const Vec3& p, const Vec3& q, double reach) {
  const Vec3 d = p - q;
  const double squared = dot(d, d);
  return judge(squared, squared, reach, 0);
}

inline Nearness nearness_of_point_segment(const Vec3& p, const Vec3& start, const Vec3& end, double reach) {
  const Vec3 edge = end - start, from = start - p;
  const double t = clamped(-dot(from, edge) / dot(edge, edge), 0, 1);
  const Vec3 d = from + t * edge;
  return judge(least_along(d, from, edge), dot(d, d), reach, sum_of_magnitudes(from) + sum_of_magnitudes(edge));
}

inline Nearness nearness_of_segments(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, double reach) {
  const Vec3 u = q - p, v = s - r, difference = p - r;
  const SegmentWeights at = nearest_weights_of_segments(difference, u, v);
  const Vec3 d = (difference + at.s * u) - at.t * v;
  const double gap = least_along(d, difference, u) - std::max(0.0, dot(v, d));
  return judge(gap, dot(d, d), reach, (sum_of_magnitudes(difference) + sum_of_magnitudes(u)) + sum_of_magnitudes(v));
}

/// The weights of the triangle's point that is nearest to the origin, by Voronoi regions: v of b, w of c.
struct TriangleWeights {
  double v = 0;
  double w = 0;
};

// Each region's planes are tests of the six products; a sign that one region has found serves the next. Section 5.1.5.
inline TriangleWeights nearest_weights(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = -dot(ab, a), d2 = -dot(ac, a);
  if (d1 <= 0 && d2 <= 0) return {0, 0};
  const double d3 = -dot(ab, b), d4 = -dot(ac, b);
  if (d3 >= 0 && d4 <= d3) return {1, 0};
  const double d5 = -dot(ab, c), d6 = -dot(ac, c);
  if (d6 >= 0 && d5 <= d6) return {0, 1};
  const double weight_c = d1 * d4 - d3 * d2;
  if (weight_c <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0};
  const double weight_b = d5 * d2 - d1 * d6;
  if (weight_b <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6)};
  const double weight_a = d3 * d6 - d5 * d4;
  if (weight_a <= 0 && d4 >= d3 && d5 >= d6) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1 - w, w};
  }
  const double whole = 1 / (weight_a + weight_b + weight_c);
  return {weight_b * whole, weight_c * whole};
}

/// `slack` is what the vertices may be off by.
inline Nearness nearness_of_point_triangle(const Vec3& p, const Triangle& t, double reach, double slack = 0) {
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const TriangleWeights at = nearest_weights(a, b, c);
  // The weights may leave the triangle by their rounding, which the bound covers once they are in [0, 1].
  if (!(at.v >= 0 && at.w >= 0 && at.v + at.w <= 1 + 0x1p-50)) return Nearness::unknown;
  const Vec3 d = (a + at.v * (b - a)) + at.w * (c - a);
  const double gap = least_of(least_of(dot(a, d), dot(b, d)), dot(c, d));
  return judge(gap, dot(d, d), reach, (sum_of_magnitudes(a) + sum_of_magnitudes(b)) + sum_of_magnitudes(c), slack);
}

[[nodiscard]] Nearness nearness_of_point_box(const Vec3& p, const PosedBox& box, double reach);

/// A point and the hull of eight corners numbered as a box's are; the formula takes it for a parallelepiped.
[[nodiscard]] Nearness nearness_of_point_corners(const Vec3& p, const std::array<const double*, 3>& corners,
                                                 double reach);

/// For two shapes, if there is a formula for the pair.
[[nodiscard]] Nearness nearness_by_formula(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
