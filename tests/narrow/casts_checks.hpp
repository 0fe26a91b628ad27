#pragma once

#include <cmath>
#include <string>

#include "oracle/convex.hpp"
#include "support/convex_cases.hpp"
#include "toccata/narrow/casts.hpp"

// What a cast has to be, by the oracle.
namespace toccata::test {

/// The oracle's sets of A at the start, and of A swept until a time.
inline oracle::ConvexSet swept(const oracle::ConvexSet& a, const Vec3& motion, double until) {
  oracle::ConvexSet result = a;
  for (const oracle::RationalPoint& v : a.vertices)
    result.vertices.push_back(v + oracle::exact(until) * oracle::exact(motion));
  return result;
}

/// Empty when the oracle finds the same: free all the way, or free until `lower` and met by `upper`.
inline std::string cast_fault(const std::optional<Cast>& cast, const oracle::ConvexSet& a, const Vec3& motion,
                              const oracle::ConvexSet& b) {
  if (oracle::overlap(swept(a, motion, 1), b) != cast.has_value())
    return cast.has_value() ? "it is free" : "it is not free";
  if (!cast) return "";
  if (oracle::overlap(a, b)) return cast->lower == 0 && cast->upper == 0 ? "" : "they meet at the start";
  if (!(cast->lower >= 0 && cast->lower <= cast->upper && cast->upper <= 1)) return "no interval of times";
  if (cast->upper - cast->lower > 1e-12) return "the interval is too wide";
  if (cast->lower < cast->upper && oracle::overlap(swept(a, motion, cast->lower), b)) return "lower is too late";
  if (!oracle::overlap(swept(a, motion, cast->upper), b)) return "upper is too early";
  if (std::fabs(dot(cast->normal, cast->normal) - 1) > 1e-12) return "the normal is not unit";
  if (!is_finite(cast->point)) return "the point is not finite";
  double size = 0;
  for (int axis = 0; axis < 3; ++axis) size += std::fabs(cast->point[axis]) + std::fabs(motion[axis]);
  const oracle::Rational slack = oracle::exact(size) * oracle::exact(1e-9);
  return oracle::compare_distance(oracle::point_set(cast->point), b, slack) <= 0 ? "" : "the point is not on B";
}

/// Towards the other shape, past it, or anywhere.
inline Vec3 random_motion(const ConvexCase& pair, Random& random) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const Vec3 towards = b.vertex(0) - a.vertex(0);
  const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
  const double size = std::sqrt(dot(towards, towards)) + 1;
  switch (random.below(4)) {
    case 0:
      return towards;
    case 1:
      return 2 * towards;
    case 2:
      return towards + (0.3 * size) * Vec3{x, y, z};
    default:
      return size * Vec3{x, y, z};
  }
}

}  // namespace toccata::test
