#include "methods/voronoi_walks.hpp"
#include "narrow/convex_cells.hpp"

namespace toccata::test {
namespace {

/// A case is a sequence.
SweepResult run_voronoi_walk(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random = random_of_cell(family, seed);
  for (; result.cases < cases; ++result.cases) {
    const std::string wrong = fault_of_walks(family, random, 16);
    if (!wrong.empty() && result.wrong++ == 0)
      result.first_failure = wrong + ", sequence " + std::to_string(result.cases);
  }
  return result;
}

const bool voronoi_walk_known =
    register_sweep({"voronoi-walk", walk_families(), 100'000 / 12 + 1, 8, run_voronoi_walk, 500, 2});

}  // namespace
}  // namespace toccata::test
