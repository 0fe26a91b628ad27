#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "oracle/penetration.hpp"
#include "support/convex_cases.hpp"
#include "toccata/narrow/convex_convex.hpp"

// What every answer about penetration has to be, compared with rational arithmetic.
namespace toccata::test {

/// The greatest magnitude of a coordinate, or the radius.
inline double size_of(const oracle::ConvexSet& set) {
  double size = set.radius.to_double();
  for (const oracle::RationalPoint& p : set.vertices)
    for (const oracle::Rational& c : {p.x, p.y, p.z}) size = std::max(size, std::fabs(c.to_double()));
  return size;
}

inline bool same_shapes(const oracle::ConvexSet& a, const oracle::ConvexSet& b) {
  return a.vertices == b.vertices && a.radius == b.radius;
}

inline bool is_nearly_unit(const Vec3& v) { return std::fabs(dot(v, v) - 1) <= 0x1p-48; }

/// The same points in the same order, seen from the other shape.
inline bool same_but_flipped(const Manifold& m, const Manifold& other) {
  if (m.count != other.count || (m.count > 0 && m.normal != -other.normal)) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    const ManifoldPoint &p = m.points[i], &q = other.points[i];
    if (p.position != q.position || p.depth != q.depth || p.on_a != q.on_b || p.on_b != q.on_a) return false;
  }
  return true;
}

/// The points are as far apart as the depth, along the direction, and lie on the shapes, up to the rounding of
/// coordinates of that size.
inline bool points_fit(const Penetration& p, const oracle::ConvexSet& a, const oracle::ConvexSet& b, double size) {
  const Vec3 rest = (p.on_a - p.on_b) - p.upper * p.direction;
  const oracle::Rational near = oracle::exact(1e-7 * size);
  return std::hypot(rest.x, rest.y, rest.z) <= 1e-12 * size &&
         oracle::compare_distance(oracle::point_set(p.on_a), a, near) <= 0 &&
         oracle::compare_distance(oracle::point_set(p.on_b), b, near) <= 0;
}

/// The interiors meet no longer once b has been moved.
inline bool is_parted_by(const oracle::ConvexSet& a, const oracle::ConvexSet& b, const oracle::RationalPoint& move) {
  return !oracle::interiors_meet(a, oracle::moved(b, move));
}

/// Empty, or what is wrong with the penetration of two solids. `size`: of all coordinates.
inline std::string wrong_with(const Penetration& p, const oracle::ConvexSet& a, const oracle::ConvexSet& b,
                              const oracle::Depth& depth, double size) {
  using oracle::exact;
  if (!(std::isfinite(p.lower) && std::isfinite(p.upper) && is_finite(p.on_a) && is_finite(p.on_b)))
    return "not finite";
  if (!is_nearly_unit(p.direction)) return "direction is no unit vector";
  if (p.lower < 0 || p.lower > p.upper) return "lower and upper";
  if (depth.compare(exact(p.lower)) < 0) return "less deep than lower";
  if (depth.compare(exact(p.upper)) > 0) return "deeper than upper";
  if (p.status != Status::exact) return "not converged";
  if (p.upper - p.lower > 0x1p-39 * p.upper) return "wide";
  const bool meet = depth.compare(0) > 0;
  if (meet != (p.lower > 0) || meet != (p.upper > 0)) return "depth and relation";
  if (!meet) return "";
  if (!is_parted_by(a, b, exact(p.upper) * exact(p.direction))) return "not parted by upper";
  if (is_parted_by(a, b, exact(0.999) * exact(p.lower) * exact(p.direction))) return "parted by less";
  return points_fit(p, a, b, size) ? "" : "points";
}

inline std::string wrong_with(const Penetration& p, const oracle::ConvexSet& a, const oracle::ConvexSet& b,
                              double size) {
  return wrong_with(p, a, b, oracle::Depth(a, b), size);
}

}  // namespace toccata::test
