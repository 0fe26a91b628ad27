// Nearest points of posed meshes: every triangle by itself, and in rational arithmetic.
#include "query/nearest_checks.hpp"
#include "support/case_seeds.hpp"

namespace toccata::test {
namespace {

std::string fault_of_nearest(const NearestCase& c, Random& random) {
  const Model model(c.mesh);
  const NearestQuery query{.pose = c.pose};
  const std::optional<SurfacePoint> one = nearest_point(c.point, model, query);
  static_cast<void>(model.leaf_triangles());
  if (!(nearest_point(c.point, model, query) == one)) return "by the triangles at the leaves";
  const std::size_t k = 1 + random.below(6);
  const std::vector<SurfacePoint> some = nearest_points(c.point, k, model, query);
  std::string fault = fault_of_nearest(c, some, k);
  if (fault.empty() && !(one == some[0])) fault = "one is not the first of some";
  if (fault.empty()) fault = fault_by_oracle(c, *one);
  if (!fault.empty()) return fault;
  NearestQuery within = query;
  within.max_distance = one->upper;
  if (!(nearest_point(c.point, model, within) == one)) return "within its distance";
  within.max_distance = one->lower * (1 - 1e-9);
  return one->lower > 0 && nearest_point(c.point, model, within) ? "beyond the greatest distance" : "";
}

SweepResult run_nearest(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases_at_simd_levels(family, seed, cases, [&](std::uint64_t case_seed) {
    Random random(case_seed);
    return fault_of_nearest(nearest_case(family, random), random);
  });
}

const bool nearest_known = register_sweep({"nearest-points", nearest_families(), 100'000, 100, run_nearest});

}  // namespace
}  // namespace toccata::test
