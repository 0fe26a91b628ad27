// Rays at posed meshes: every triangle in rational arithmetic.
#include "query/ray_checks.hpp"
#include "support/case_seeds.hpp"

namespace toccata::test {
namespace {

SweepResult run_rays(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) {
    Random random(case_seed);
    const RayCase c = ray_case(family, random);
    const Model model(c.mesh);
    const std::optional<RayHit> by_boxes = cast_ray(c.origin, c.motion, model, c.pose, Solid::none);
    static_cast<void>(model.leaf_triangles());
    const std::optional<RayHit> hit = cast_ray(c.origin, c.motion, model, c.pose, Solid::none);
    return hit == by_boxes ? ray_fault(c, hit) : "another answer by the triangles at the leaves";
  });
}

const bool rays_known = register_sweep({"rays", ray_families(), 100'000, 200, run_rays, 10'000, 40});

}  // namespace
}  // namespace toccata::test
