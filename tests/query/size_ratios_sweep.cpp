#include "query/mesh_casts_checks.hpp"
#include "support/case_seeds.hpp"
#include "support/mesh_distances.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "support/size_ratios.hpp"

namespace toccata::test {
namespace {

UnlikeSizes unlike_sizes(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  return random_unlike_sizes(family, random);
}

SweepResult run_size_ratios(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(family, seed, cases, [&](std::uint64_t case_seed) {
    const UnlikeSizes pair = unlike_sizes(family, case_seed);
    const std::string fault = fault_of_surface_queries(pair.large, pair.small, pair.query);
    return fault.empty() ? fault : fault + " differs from brute force";
  });
}

SweepResult run_distances(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(family, seed, cases, [&](std::uint64_t case_seed) {
    const UnlikeSizes pair = unlike_sizes(family, case_seed);
    return fault_of_surface_distance(pair.large, pair.small, pair.query);
  });
}

SweepResult run_casts(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) {
    Random random(case_seed);
    const UnlikeSizes pair = random_unlike_sizes(family, random);
    const Vec3 motion = random_vector(random, 3 * pair.ratio);
    std::string fault = mesh_cast_fault(pair.large, motion, pair.small, pair.query);
    if (!fault.empty()) return fault;
    const std::string other_way = mesh_cast_fault(pair.small, -motion, pair.large, exchanged(pair.query));
    return other_way.empty() ? "" : "the small one moves: " + other_way;
  });
}

// Overlap, first contact and all contacts of a mesh and one that is up to a million times smaller, against brute force,
// both ways round, the SIMD levels in turn.
const bool size_ratios_known = register_sweep({"size-ratios", pose_families(), 100000, 1000, run_size_ratios});

// Their distances against the certified distance of every pair of triangles, both ways round, warm and cold.
const bool unlike_distances_known =
    register_sweep({"distances-of-unlike-sizes", pose_families(), 10000, 100, run_distances});

// When one first meets the other as it moves, against the cast of every pair of triangles, either of them moving.
const bool unlike_casts_known = register_sweep({"casts-of-unlike-sizes", pose_families(), 10000, 20, run_casts});

}  // namespace
}  // namespace toccata::test
