#include <cmath>

#include "support/case_seeds.hpp"
#include "support/closeness.hpp"
#include "support/mesh_soups.hpp"

namespace toccata::test {
namespace {

std::string fault_of_within_distance(const std::string& family, std::uint64_t seed) {
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

SweepResult run_within_distance(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(family, seed, cases,
                                  [&](std::uint64_t case_seed) { return fault_of_within_distance(family, case_seed); });
}

// Two posed surfaces and tolerances at their distance, a double off it and elsewhere, against the exact rational
// distance, both ways round, warm and cold, the SIMD levels in turn.
const bool within_distance_known = register_sweep({"within-distance", pose_families(), 10000, 20, run_within_distance});

}  // namespace
}  // namespace toccata::test
