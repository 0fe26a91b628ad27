// Faces within a box or a ball: every triangle in rational arithmetic.
#include "query/region_checks.hpp"
#include "support/case_seeds.hpp"

namespace toccata::test {
namespace {

SweepResult run_faces_in_region(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(family, seed, cases, [&](std::uint64_t case_seed) -> std::string {
    Random random(case_seed);
    const RegionCase c = region_case(family, random);
    return faces_in_region(c.region, Model(c.mesh), c.pose) == exact_faces_in_region(c) ? ""
                                                                                        : "other faces than in truth";
  });
}

const bool faces_in_region_known =
    register_sweep({"faces-in-region", region_families(), 1'000'000, 125, run_faces_in_region, 5000, 25});

}  // namespace
}  // namespace toccata::test
