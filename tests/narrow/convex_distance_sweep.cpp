#include "narrow/convex_distance_checks.hpp"
#include "narrow/convex_sweeps.hpp"

// The distance of two convex shapes: the interval holds the exact one and is narrow, and the witness points are
// the nearest points.
namespace toccata::test {
namespace {

Distance ask_convex_distance(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  return distance(a, b, workspace);
}

std::string check_convex_distance(const SeenCase& seen) {
  const Distance d = distance(seen.a, seen.b);
  if (d.status != Status::exact) return "status";
  for (const std::string& wrong : {interval_fault(d, seen.set_a, seen.set_b), witness_fault(d, seen.set_a, seen.set_b),
                                   exact_witness_fault(d, seen.a, seen.b, size_of(seen.set_a, seen.set_b))})
    if (!wrong.empty()) return wrong;
  const Distance other_way = distance(seen.b, seen.a);
  if (other_way.lower != d.lower || other_way.upper != d.upper) return "exchanged";
  // Common points of cores are those in which each search ended.
  if (d.upper > 0 && other_way != exchanged(d)) return "witnesses exchanged";
  const std::string wrong = witness_fault(exchanged(other_way), seen.set_a, seen.set_b);
  return wrong.empty() ? compare_warm(seen, ask_convex_distance) : wrong;
}

SweepResult run_convex_distance(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_convex_cases(cell, seed, cases, check_convex_distance);
}

const bool convex_distance_known = register_sweep({"convex-distance", cells_of(convex_kinds()), cell_goal, cell_slice,
                                                   run_convex_distance, cell_shard, 4 * cell_round});

}  // namespace
}  // namespace toccata::test
