// Rays at posed meshes: every triangle in rational arithmetic.
#include "query/ray_checks.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random seeds(seed);
  for (; result.cases < cases; ++result.cases) {
    const std::uint64_t case_seed = seeds.bits();
    Random random(case_seed);
    const RayCase c = ray_case(family, random);
    const std::string fault = ray_fault(c, cast_ray(c.origin, c.motion, Model(c.mesh), c.pose, Solid::none));
    if (!fault.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case seed {}: {}", family, case_seed, fault);
  }
  return result;
}

const bool known = register_sweep({"rays", ray_families(), 100'000, 200, run});

}  // namespace
}  // namespace toccata::test
