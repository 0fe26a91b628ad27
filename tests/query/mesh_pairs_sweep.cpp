#include <fmt/format.h>

#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "support/sweep.hpp"
#include "toccata/core/simd.hpp"

namespace toccata::test {
namespace {

/// Mostly small meshes; now and then one of up to 2,000 triangles.
Index triangle_count(Random& random) {
  const std::uint64_t greatest = random.below(20) == 0 ? 2000 : random.below(2) == 0 ? 12 : 150;
  return static_cast<Index>(1 + random.below(greatest));
}

Model random_model(Random& random) {
  const Index triangles = triangle_count(random);
  const double size = random.below(2) == 0 ? 0.3 : 1.0 / (1.0 + static_cast<double>(triangles));
  const double grid = random.below(2) == 0 ? 0 : 8;
  return Model(random_soup(random, triangles, size, grid));
}

std::string fault_of_case(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const PairQuery query = random_poses(family, random);
  const Model a = random_model(random), b = random_model(random);
  return fault_of_surface_queries(a, b, query);
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
      result.first_failure = fmt::format("{}, case seed {}: {} differs from brute force", family, case_seed, fault);
  }
  use_simd_level(before);
  return result;
}

// Overlap, first contact and all contacts of two posed surfaces against brute force, both ways round, the SIMD levels
// in turn.
const bool known = register_sweep({"mesh-pairs", pose_families(), 10000, 100, run});

}  // namespace
}  // namespace toccata::test
