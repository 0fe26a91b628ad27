// Overlap volumes of meshes against those of the regularised intersection of CGAL's Nef polyhedra, in exact numbers.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "query/cgal_solids.hpp"
#include "support/case_seeds.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

/// The volume of a bounded solid is that of the signed tetrahedra over its triangles.
CgalNumber exact_volume(const CgalNef& solid) {
  CgalNumber six_volumes = 0;
  for (const CgalTriangle& t : triangles_of(solid))
    six_volumes += CGAL::determinant(t[0] - CGAL::ORIGIN, t[1] - CGAL::ORIGIN, t[2] - CGAL::ORIGIN);
  return CGAL::abs(six_volumes) / 6;
}

std::string fault_beside_cgal(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const TriangleMesh mesh_a = solid_for_cgal(family, random), mesh_b = solid_for_cgal(family, random);
  const PairQuery query{.pose_a = {some_turn(random), {}},
                        .pose_b = {some_turn(random), random.below(8) == 0 ? Vec3{} : random_vector(random, 0.8)}};
  const CgalNumber truth = exact_volume(cgal_solid(mesh_a, query.pose_a) * cgal_solid(mesh_b, query.pose_b));
  const OverlapVolume found = overlap_volume(Model(mesh_a), Model(mesh_b), query);
  const auto told = [&] {
    return fmt::format("[{}, {}], CGAL {}", found.lower, found.upper, CGAL::to_double(CGAL::exact(truth)));
  };
  if (!(CgalNumber(found.lower) <= truth)) return "lower is above the exact volume: " + told();
  if (!(truth <= CgalNumber(found.upper))) return "upper is below the exact volume: " + told();
  if (found.upper - found.lower > 1e-12 * (found.upper + 1e-3)) return "the bracket is wide: " + told();
  return "";
}

SweepResult run_volumes_beside_cgal(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) { return fault_beside_cgal(family, case_seed); });
}

const bool volumes_cgal_known = register_sweep({"overlap-volumes-cgal",
                                                {"boxes", "spheres", "prisms", "tetrahedra", "l shapes", "mixed"},
                                                10'000,
                                                10,
                                                run_volumes_beside_cgal,
                                                200});

}  // namespace
}  // namespace toccata::test
