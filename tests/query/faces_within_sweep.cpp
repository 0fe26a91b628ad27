// Faces within a box or a ball: every triangle in rational arithmetic.
#include "query/region_checks.hpp"
#include "support/sweep.hpp"
#include "toccata/core/simd.hpp"

namespace toccata::test {
namespace {

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random seeds(seed);
  const SimdLevel before = simd_level();
  const std::vector<SimdLevel> levels = simd_levels();
  for (; result.cases < cases; ++result.cases) {
    const std::uint64_t case_seed = seeds.bits();
    use_simd_level(levels[case_seed % levels.size()]);
    Random random(case_seed);
    const RegionCase c = region_case(family, random);
    if (faces_within(c.region, Model(c.mesh), c.pose) == exact_faces_within(c)) continue;
    if (result.wrong++ == 0) result.first_failure = fmt::format("{}, case seed {}", family, case_seed);
  }
  use_simd_level(before);
  return result;
}

const bool known = register_sweep({"faces-within", region_families(), 1'000'000, 125, run, 5000, 25});

}  // namespace
}  // namespace toccata::test
