#include "narrow/convex_sweeps.hpp"

// Whether two convex shapes meet, compared with rational arithmetic.
namespace toccata::test {
namespace {

bool ask_convex_overlap(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  return overlap(a, b, workspace);
}

std::string check_convex_overlap(const SeenCase& seen) {
  const bool truth = oracle::overlap(seen.set_a, seen.set_b);
  if (overlap(seen.a, seen.b) != truth) return truth ? "they meet" : "they do not meet";
  if (overlap(seen.b, seen.a) != truth) return "exchanged";
  return compare_warm(seen, ask_convex_overlap);
}

SweepResult run_convex_overlap(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_convex_cases(cell, seed, cases, check_convex_overlap);
}

const bool convex_overlap_known = register_sweep({"convex-overlap", cells_of(convex_kinds()), cell_goal, cell_slice,
                                                  run_convex_overlap, cell_shard, 10 * cell_round});

}  // namespace
}  // namespace toccata::test
