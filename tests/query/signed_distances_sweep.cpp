// Signed distances from closed meshes: the winding number and the distance of every triangle in rational arithmetic.
#include "query/signed_distance_checks.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random seeds(seed);
  for (; result.cases < cases; ++result.cases) {
    const std::uint64_t case_seed = seeds.bits();
    Random random(case_seed);
    const PointCase c = closed_case(family, random);
    const std::string fault = signed_fault(c, signed_distance(c.point, Model(c.mesh), c.pose));
    if (!fault.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case seed {}: {}", family, case_seed, fault);
  }
  return result;
}

const bool known = register_sweep({"signed-distances", closed_families(), 100'000, 60, run, 2000, 10});

}  // namespace
}  // namespace toccata::test
