#include "support/case_seeds.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"

namespace toccata::test {
namespace {

/// Mostly small meshes; now and then one of up to 2,000 triangles.
Index triangle_count(Random& random) {
  const std::uint64_t greatest = random.below(20) == 0 ? 2000 : random.below(2) == 0 ? 12 : 150;
  return static_cast<Index>(1 + random.below(greatest));
}

Model model_of_any_size(Random& random) {
  const Index triangles = triangle_count(random);
  const double size = random.below(2) == 0 ? 0.3 : 1.0 / (1.0 + static_cast<double>(triangles));
  const double grid = random.below(2) == 0 ? 0 : 8;
  return Model(random_soup(random, triangles, size, grid));
}

std::string fault_of_mesh_pairs(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const PairQuery query = random_poses(family, random);
  const Model a = model_of_any_size(random), b = model_of_any_size(random);
  return fault_of_surface_queries(a, b, query);
}

SweepResult run_mesh_pairs(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(family, seed, cases, [&](std::uint64_t case_seed) {
    const std::string fault = fault_of_mesh_pairs(family, case_seed);
    return fault.empty() ? fault : fault + " differs from brute force";
  });
}

// Overlap, first contact and all contacts of two posed surfaces against brute force, both ways round, the SIMD levels
// in turn.
const bool mesh_pairs_known = register_sweep({"mesh-pairs", pose_families(), 10000, 100, run_mesh_pairs});

}  // namespace
}  // namespace toccata::test
