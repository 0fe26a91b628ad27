#include "support/case_seeds.hpp"
#include "support/coherence.hpp"
#include "toccata/core/random.hpp"

namespace toccata::test {
namespace {

constexpr int steps = 20;

SweepResult run_coherent_distances(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(
      family, seed, cases, [&](std::uint64_t case_seed) { return fault_of_coherence(family, case_seed, steps); });
}

// Two meshes on a way of twenty steps, every distance with a cache against the one without, to the bit, the SIMD levels
// in turn.
const bool coherent_distances_known =
    register_sweep({"coherent-distances", motion_families(), 10000, 6, run_coherent_distances});

}  // namespace
}  // namespace toccata::test
