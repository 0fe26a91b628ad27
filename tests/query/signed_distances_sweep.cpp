// Signed distances from closed meshes: the winding number and the distance of every triangle in rational arithmetic.
#include "query/signed_distance_checks.hpp"
#include "support/case_seeds.hpp"

namespace toccata::test {
namespace {

SweepResult run_signed_distances(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) {
    Random random(case_seed);
    const PointCase c = closed_case(family, random);
    return signed_fault(c, signed_distance(c.point, Model(c.mesh), c.pose));
  });
}

const bool signed_distances_known =
    register_sweep({"signed-distances", closed_families(), 100'000, 60, run_signed_distances, 2000, 10});

}  // namespace
}  // namespace toccata::test
