#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "narrow/convex_cells.hpp"
#include "support/convex_cases.hpp"
#include "toccata/narrow/convex_convex.hpp"

// What the sweeps over pairs of convex shapes have in common.
namespace toccata::test {

/// A case, as the library and as the oracle see it.
struct SeenCase {
  const ConvexCase& given;
  PosedPolytope a;
  PosedPolytope b;
  oracle::ConvexSet set_a;
  oracle::ConvexSet set_b;
  /// The cache of the last case of the sweep: what it holds is of no use here, and must do no harm.
  SimplexCache& stale;
};

/// Cases of a cell. `check` is given each, and gives nothing, or what is wrong.
template <class Check>
SweepResult run_convex_cases(const std::string& cell, std::uint64_t seed, std::uint64_t cases, Check check) {
  SimplexCache workspace;
  return run_cell(cell, seed, cases, [&](const ConvexCase& pair, Random&) {
    return check({pair, posed(pair.a), posed(pair.b), set_of(pair.a), set_of(pair.b), workspace});
  });
}

/// The same bits without a workspace, with one that knows another case, and with one that knows this one.
template <class Question>
std::string compare_warm(const SeenCase& seen, Question question) {
  const auto cold = question(seen.a, seen.b, nullptr);
  if (!(question(seen.a, seen.b, &seen.stale) == cold)) return "with a stale workspace";
  if (!(question(seen.a, seen.b, &seen.stale) == cold)) return "warm";
  return "";
}

/// The largest coordinate of the shapes' vertices, grown by the radii.
inline double largest_coordinate(const SeenCase& seen) {
  double largest = 0;
  for (const PosedPolytope* shape : {&seen.a, &seen.b})
    for (Index i = 0; i < shape->vertex_count(); ++i) {
      const Vec3 v = shape->vertex(i);
      largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    }
  return largest + seen.a.radius() + seen.b.radius();
}

inline bool is_unit(const Vec3& v) { return std::abs(dot(v, v) - 1) <= 1e-15; }

/// The bracket is 10⁻¹² of the depth wide, or some of the least doubles there are.
inline bool is_narrow(const Penetration& p) {
  return p.lower <= p.upper && p.upper - p.lower <= std::max(1e-12 * p.upper, 0x1p-1070);
}

/// The point is no farther from the set.
inline bool is_within(const Vec3& point, const oracle::ConvexSet& set, double distance) {
  return is_finite(point) && oracle::compare_distance(oracle::point_set(point), set, oracle::exact(distance)) <= 0;
}

}  // namespace toccata::test
