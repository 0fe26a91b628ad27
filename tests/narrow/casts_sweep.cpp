#include "narrow/casts_checks.hpp"
#include "narrow/convex_cells.hpp"

// Every kind of convex shape cast against every kind, from every regime, as the oracle answers.
namespace toccata::test {
namespace {

std::string check(const ConvexCase& pair, Random& random) {
  const Vec3 motion = random_motion(pair, random);
  return cast_fault(cast_shape(posed(pair.a), motion, posed(pair.b)), set_of(pair.a), motion, set_of(pair.b));
}

SweepResult run(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_cell(cell, seed, cases, check);
}

const bool known =
    register_sweep({"casts", cells_of(convex_kinds()), cell_goal, 20 * cell_round, run, cell_shard, cell_round});

}  // namespace
}  // namespace toccata::test
