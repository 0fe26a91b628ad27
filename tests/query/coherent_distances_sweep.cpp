#include <fmt/format.h>

#include "support/coherence.hpp"
#include "support/sweep.hpp"
#include "toccata/core/random.hpp"
#include "toccata/core/simd.hpp"

namespace toccata::test {
namespace {

constexpr int steps = 20;

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random seeds(seed);
  const SimdLevel before = simd_level();
  const std::vector<SimdLevel> levels = simd_levels();
  for (; result.cases < cases; ++result.cases) {
    const std::uint64_t case_seed = seeds.bits();
    use_simd_level(levels[case_seed % levels.size()]);
    const std::string fault = fault_of_coherence(family, case_seed, steps);
    if (fault.empty()) continue;
    ++result.wrong;
    if (result.first_failure.empty())
      result.first_failure = fmt::format("{}, case seed {}: {}", family, case_seed, fault);
  }
  use_simd_level(before);
  return result;
}

// Two meshes on a way of twenty steps, every distance with a cache against the one without, to the bit, the SIMD levels
// in turn.
const bool known = register_sweep({"coherent-distances", motion_families(), 10000, 6, run});

}  // namespace
}  // namespace toccata::test
