// Casts of which a side is a mesh: every pair of triangles, and the oracle's sets for meshes of hulls.
#include "query/mesh_casts_checks.hpp"
#include "support/case_seeds.hpp"

namespace toccata::test {
namespace {

std::string fault_of_soup(const std::string& family, Random& random) {
  const MeshCastCase c = mesh_cast_case(family, random);
  std::string fault = mesh_cast_fault(c.a, c.motion, c.b, c.query);
  if (!fault.empty()) return fault;
  const std::string other_way = mesh_cast_fault(c.b, -c.motion, c.a, exchanged(c.query));
  return other_way.empty() ? "" : "the mesh moves: " + other_way;
}

std::string fault_of_hull(const std::string& regime, Random& random) {
  const std::vector<std::string> meshes{"triangle", "box", "hull"};
  const std::string& kind = convex_kinds()[random.below(convex_kinds().size())];
  const ConvexCase pair = convex_case(meshes[random.below(3)], kind, regime, random);
  return hull_cast_fault(pair, random_motion(pair, random));
}

SweepResult run_mesh_casts(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  const bool is_regime = family.starts_with("hull, ");
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) {
    Random random(case_seed);
    return is_regime ? fault_of_hull(family.substr(6), random) : fault_of_soup(family, random);
  });
}

std::vector<std::string> families() {
  std::vector<std::string> all = mesh_cast_families();
  for (const std::string& regime : convex_regimes()) all.push_back("hull, " + regime);
  return all;
}

const bool mesh_casts_known = register_sweep({"mesh-casts", families(), 10'000, 12, run_mesh_casts, 1'000, 4});

}  // namespace
}  // namespace toccata::test
