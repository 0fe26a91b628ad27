#include <fmt/format.h>

#include <cmath>

#include "support/closeness.hpp"
#include "support/mesh_soups.hpp"
#include "support/sweep.hpp"
#include "toccata/core/simd.hpp"

namespace toccata::test {
namespace {

std::string fault_of_case(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  PairQuery query = random_poses(family, random);
  const double way = random.below(3) == 0 ? 0 : std::exp2(random.between(-20, 8));
  query.pose_b.offset = query.pose_b.offset + way * Vec3{random.between(-1, 1), random.between(-1, 1), 1};
  const auto model = [&] {
    const auto triangles = static_cast<Index>(1 + random.below(6));
    return Model(random_soup(random, triangles, std::exp2(random.between(-6, 0)), random.below(2) == 0 ? 0 : 8));
  };
  const Model a = model(), b = model();
  return fault_of_closeness(a, b, query);
}

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random seeds(seed);
  const SimdLevel before = simd_level();
  const std::vector<SimdLevel> levels = simd_levels();
  for (; result.cases < cases; ++result.cases) {
    const std::uint64_t case_seed = seeds.bits();
    use_simd_level(levels[case_seed % levels.size()]);
    const std::string fault = fault_of_case(family, case_seed);
    if (fault.empty()) continue;
    ++result.wrong;
    if (result.first_failure.empty())
      result.first_failure = fmt::format("{}, case seed {}: {}", family, case_seed, fault);
  }
  use_simd_level(before);
  return result;
}

// Two posed surfaces and tolerances at their distance, a double off it and elsewhere, against the exact rational
// distance, both ways round, warm and cold, the SIMD levels in turn.
const bool known = register_sweep({"closer-than", pose_families(), 10000, 20, run});

}  // namespace
}  // namespace toccata::test
