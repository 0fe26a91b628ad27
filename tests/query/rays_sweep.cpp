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
    const Model model(c.mesh);
    const RayHit by_boxes = cast_ray(c.origin, c.motion, model, c.pose, Solid::none);
    static_cast<void>(model.leaf_triangles());
    const RayHit hit = cast_ray(c.origin, c.motion, model, c.pose, Solid::none);
    const std::string fault = hit == by_boxes ? ray_fault(c, hit) : "another answer by the triangles at the leaves";
    if (!fault.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case seed {}: {}", family, case_seed, fault);
  }
  return result;
}

const bool known = register_sweep({"rays", ray_families(), 100'000, 200, run, 10'000, 40});

}  // namespace
}  // namespace toccata::test
