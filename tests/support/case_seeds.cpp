#include "support/case_seeds.hpp"

#include <fmt/format.h>

#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/core/simd.hpp"

namespace toccata::test {

SweepResult run_cases(const std::string& family, std::uint64_t seed, std::uint64_t cases,
                      const FaultOfCase& fault_of_case) {
  SweepResult result;
  Random seeds(seed);
  for (; result.cases < cases; ++result.cases) {
    const std::uint64_t case_seed = seeds.bits();
    const std::string fault = fault_of_case(case_seed);
    if (!fault.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case seed {}: {}", family, case_seed, fault);
  }
  return result;
}

SweepResult run_cases_at_simd_levels(const std::string& family, std::uint64_t seed, std::uint64_t cases,
                                     const FaultOfCase& fault_of_case) {
  const SimdLevel before = simd_level();
  const std::vector<SimdLevel> levels = simd_levels();
  SweepResult result = run_cases(family, seed, cases, [&](std::uint64_t case_seed) {
    use_simd_level(levels[case_seed % levels.size()]);
    return fault_of_case(case_seed);
  });
  use_simd_level(before);
  return result;
}

}  // namespace toccata::test
