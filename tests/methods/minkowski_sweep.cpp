#include "methods/minkowski_checks.hpp"
#include "narrow/convex_sweeps.hpp"
#include "toccata/methods/minkowski.hpp"

// The boundary of sums and differences, compared with rational arithmetic; and the origin in a difference, with
// overlap.
namespace toccata::test {
namespace {

std::string check_sum(const SeenCase& seen) {
  const MinkowskiSum sum = minkowski_sum(seen.a, seen.b), difference = minkowski_difference(seen.a, seen.b);
  std::string wrong = sum_fault(sum, {seen.a, seen.b, false});
  if (wrong.empty()) wrong = sum_fault(difference, {seen.a, seen.b, true});
  if (!wrong.empty()) return wrong;
  if (minkowski_sum(seen.b, seen.a).vertex_count() != sum.vertex_count()) return "exchanged";
  return difference.contains({}) == overlap(seen.a, seen.b) ? "" : "the origin in the difference";
}

SweepResult run_sums(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_convex_cases(cell, seed, cases, check_sum);
}

const bool sums_known = register_sweep(
    {"minkowski-sums", cells_of({"point", "segment", "triangle", "box", "hull", "flat-hull", "needle-hull"}), 10'000,
     2 * cell_round, run_sums, cell_shard, cell_round});

}  // namespace
}  // namespace toccata::test
