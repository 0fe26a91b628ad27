#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/convex_cases.hpp"
#include "support/sweep.hpp"
#include "toccata/narrow/convex_convex.hpp"

// What the sweeps over pairs of convex shapes have in common.
namespace toccata::test {

/// A case, as the library and as the oracle see it.
struct SeenCase {
  const ConvexCase& given;
  PosedConvex a;
  PosedConvex b;
  oracle::ConvexSet set_a;
  oracle::ConvexSet set_b;
  /// Of the last case of the sweep: what it holds is of no use here, and must do no harm.
  ConvexWorkspace& stale;
};

/// Every ordered pair of kinds and regimes in a family, which is the kind of A: 14 kinds of B times 15 regimes, the
/// numbers of which have no common factor, so that as many cases go through all. `check` gives nothing, or what is
/// wrong.
template <class Check>
SweepResult run_convex_cases(const std::string& kind_a, std::uint64_t seed, std::uint64_t cases, Check check) {
  SweepResult result;
  const auto kind_number = std::ranges::find(convex_kinds(), kind_a) - convex_kinds().begin();
  Random random(seed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(kind_number));
  ConvexWorkspace workspace;
  for (; result.cases < cases; ++result.cases) {
    const ConvexCase pair = numbered_case(kind_a, seed * 1000 + result.cases, random);
    const SeenCase seen{pair, posed(pair.a), posed(pair.b), set_of(pair.a), set_of(pair.b), workspace};
    const std::string wrong = check(seen);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = wrong + ", case " + std::to_string(result.cases) + ": " + to_text(pair);
  }
  return result;
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
  for (const PosedConvex* shape : {&seen.a, &seen.b})
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

constexpr std::uint64_t cases_of_all_cells = 14 * 15;
/// Of each family; 10⁵ of each cell, which two families share where the kinds are two.
constexpr std::uint64_t convex_goal = 14 * 100'000;
constexpr std::uint64_t convex_slice = 75;
constexpr std::uint64_t convex_shard = 10 * cases_of_all_cells;

}  // namespace toccata::test
