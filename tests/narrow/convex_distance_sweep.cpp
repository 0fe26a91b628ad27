#include "narrow/convex_sweeps.hpp"

// The distance of two convex shapes: the interval holds the exact one and is the least of doubles that does, and the
// witness points lie on the shapes, that far from each other.
namespace toccata::test {
namespace {

Distance ask(const PosedConvex& a, const PosedConvex& b, ConvexWorkspace* workspace) {
  return distance(a, b, workspace);
}

std::string check_interval(const Distance& d, const SeenCase& seen) {
  if (!(d.lower >= 0) || !std::isfinite(d.upper)) return "no number";
  const int of_lower = oracle::compare_distance(seen.set_a, seen.set_b, oracle::exact(d.lower));
  if (d.lower == d.upper) return of_lower == 0 ? "" : of_lower < 0 ? "too large" : "too small";
  if (of_lower <= 0) return "lower is too large";
  if (oracle::compare_distance(seen.set_a, seen.set_b, oracle::exact(d.upper)) >= 0) return "upper is too small";
  return std::nextafter(d.lower, d.upper) == d.upper ? "" : "the interval is wide";
}

std::string check_witnesses(const Distance& d, const SeenCase& seen) {
  const double rounding = 0x1p-52 * largest_coordinate(seen);
  if (!is_within(d.on_a, seen.set_a, rounding)) return "on_a is not on A";
  if (!is_within(d.on_b, seen.set_b, rounding)) return "on_b is not on B";
  const Vec3 apart = d.on_a - d.on_b;
  return std::abs(std::hypot(apart.x, apart.y, apart.z) - d.upper) <= 4 * rounding ? "" : "witnesses are not that far";
}

std::string check(const SeenCase& seen) {
  const Distance d = distance(seen.a, seen.b);
  if (d.status != Status::exact) return "status";
  for (const std::string& wrong : {check_interval(d, seen), check_witnesses(d, seen)})
    if (!wrong.empty()) return wrong;
  const Distance exchanged = distance(seen.b, seen.a);
  if (exchanged.lower != d.lower || exchanged.upper != d.upper) return "exchanged";
  if (!check_witnesses({d.lower, d.upper, exchanged.on_b, exchanged.on_a}, seen).empty()) return "witnesses exchanged";
  return compare_warm(seen, ask);
}

SweepResult run(const std::string& kind, std::uint64_t seed, std::uint64_t cases) {
  return run_convex_cases(kind, seed, cases, check);
}

const bool known = register_sweep({"convex-distance", convex_kinds(), convex_goal, convex_slice, run, convex_shard});

}  // namespace
}  // namespace toccata::test
