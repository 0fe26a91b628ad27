#include "narrow/casts_checks.hpp"
#include "narrow/convex_cells.hpp"

// Every kind of convex shape cast against every kind, from every regime, as the oracle answers.
namespace toccata::test {
namespace {

std::string check_casts(const ConvexCase& pair, Random& random) {
  const Vec3 motion = random_motion(pair, random);
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const std::optional<Cast> cast = cast_shape(a, motion, b);
  SimplexCache workspace;
  // The first question tells the workspace what the second may use.
  const int warm = random.below(4) == 0 ? 2 : 0;
  for (int i = 0; i < warm; ++i)
    if (!(cast_shape(a, motion, b, &workspace) == cast)) return "with a workspace";
  return cast_fault(cast, set_of(pair.a), motion, set_of(pair.b));
}

SweepResult run_casts(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_cell(cell, seed, cases, check_casts);
}

const bool casts_known =
    register_sweep({"casts", cells_of(convex_kinds()), cell_goal, 20 * cell_round, run_casts, cell_shard, cell_round});

}  // namespace
}  // namespace toccata::test
