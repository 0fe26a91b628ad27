#include "narrow/convex_sweeps.hpp"

#include <fmt/format.h>
#include "oracle/penetration.hpp"
#include "toccata/core/error.hpp"

// Every question about a convex shape and a half-space, compared with rational arithmetic.
namespace toccata::test {
namespace {

struct SeenHalfSpace {
  bool a_solid;
  PosedPolytope a;
  PosedHalfSpace b;
  oracle::ConvexSet set_a;
  oracle::HalfSpace set_b;
};

std::string check_yes_or_no(const SeenHalfSpace& seen) {
  const oracle::Relation truth = oracle::relation(seen.set_a, seen.set_b);
  if (overlap(seen.a, seen.b) != (truth.kind != oracle::RelationKind::apart)) return "overlap";
  // Rounding may bend a flat hull; the oracle then sees a solid.
  if (seen.a_solid != oracle::is_solid(seen.set_a)) return "";
  const Relation answer = relation(seen.a, seen.b);
  const Relation expected{static_cast<RelationKind>(truth.kind),
                          static_cast<Containment>(truth.containment),
                          false,
                          seen.a_solid,
                          true,
                          Status::exact};
  return answer == expected ? "" : "relation";
}

std::string check_distance(const SeenHalfSpace& seen) {
  const Distance d = distance(seen.a, seen.b);
  const int of_lower = oracle::compare_distance(seen.set_a, seen.set_b, oracle::exact(d.lower));
  const int of_upper = oracle::compare_distance(seen.set_a, seen.set_b, oracle::exact(d.upper));
  if (d.lower == d.upper) return of_lower == 0 ? "" : "distance";
  if (of_lower <= 0 || of_upper >= 0) return "distance outside of its interval";
  return std::nextafter(d.lower, d.upper) == d.upper ? "" : "the interval of the distance is wide";
}

bool is_refused(const SeenHalfSpace& seen) {
  try {
    static_cast<void>(penetration(seen.a, seen.b));
    return false;
  } catch (const Error&) {
    return true;
  }
}

std::string check_penetration(const SeenHalfSpace& seen) {
  if (!seen.a_solid) return is_refused(seen) ? "" : "a surface is not refused";
  const Penetration p = penetration(seen.a, seen.b);
  if (!oracle::is_solid(seen.set_a)) return p.upper == 0 ? "" : "what rounding has flattened has a depth";
  if (oracle::compare_penetration(seen.set_a, seen.set_b, oracle::exact(p.lower)) < 0) return "penetration is less";
  if (oracle::compare_penetration(seen.set_a, seen.set_b, oracle::exact(p.upper)) > 0) return "penetration is more";
  if (!is_narrow(p)) return "the bracket of the penetration is wide";
  return p.upper == 0 || is_unit(p.direction) ? "" : "the direction is not of length 1";
}

std::string check_manifold(const SeenHalfSpace& seen) {
  const Manifold m = manifold(seen.a, seen.b);
  if ((m.count > 0) != oracle::overlap(seen.set_a, seen.set_b)) return "manifold";
  return m.count == 0 || is_unit(m.normal) ? "" : "the normal is not of length 1";
}

SweepResult run_convex_half_space(const std::string& kind, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(Random(seed).bits() + 3);
  for (; result.cases < cases; ++result.cases) {
    const std::string& regime = convex_regimes()[result.cases % convex_regimes().size()];
    const HalfSpaceCase pair = half_space_case(kind, regime, random);
    const SeenHalfSpace seen{is_solid(pair.a), posed(pair.a), posed(pair.b), set_of(pair.a), set_of(pair.b)};
    std::string wrong;
    for (const auto& check : {check_yes_or_no, check_distance, check_penetration, check_manifold})
      if (wrong.empty()) wrong = check(seen);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case {} ({}): {}", wrong, result.cases, regime, to_text(pair));
  }
  return result;
}

const bool convex_half_space_known =
    register_sweep({"convex-half-space", convex_kinds(), 100'000, 1005, run_convex_half_space, 9'000, 90});

}  // namespace
}  // namespace toccata::test
