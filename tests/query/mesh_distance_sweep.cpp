#include <cmath>

#include "support/case_seeds.hpp"
#include "support/mesh_distances.hpp"
#include "support/mesh_soups.hpp"

namespace toccata::test {
namespace {

Model small_model(Random& random) {
  const auto triangles = static_cast<Index>(1 + random.below(random.below(8) == 0 ? 60 : 12));
  const double size = std::exp2(random.between(-6, 0));
  return Model(random_soup(random, triangles, size, random.below(2) == 0 ? 0 : 8));
}

std::string fault_of_mesh_distance(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  PairQuery query = random_poses(family, random);
  const double way = random.below(3) == 0 ? 0 : std::exp2(random.between(-20, 8));
  query.pose_b.offset = query.pose_b.offset + way * Vec3{random.between(-1, 1), random.between(-1, 1), 1};
  const Model a = small_model(random), b = small_model(random);
  return fault_of_surface_distance(a, b, query);
}

SweepResult run_mesh_distance(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(family, seed, cases,
                                  [&](std::uint64_t case_seed) { return fault_of_mesh_distance(family, case_seed); });
}

// Distances of two posed surfaces against the certified distance of every pair of triangles, both ways round, warm and
// cold, the SIMD levels in turn.
const bool mesh_distance_known = register_sweep({"mesh-distances", pose_families(), 10000, 50, run_mesh_distance});

}  // namespace
}  // namespace toccata::test
