// Overlap volumes of meshes against those of the regularised intersection of CGAL's Nef polyhedra, in exact numbers.
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "query/cgal_solids.hpp"
#include "support/case_seeds.hpp"
#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

using CgalNumber = CgalKernel::FT;
using CgalPoint = CgalKernel::Point_3;

/// The volume of a bounded solid is that of the signed tetrahedra over its triangles.
CgalNumber exact_volume(const CgalNef& solid) {
  std::vector<CgalPoint> points;
  std::vector<std::vector<std::size_t>> triangles;
  constexpr bool in_triangles = true;
  CGAL::convert_nef_polyhedron_to_polygon_soup(solid, points, triangles, in_triangles);
  CgalNumber six_volumes = 0;
  for (const std::vector<std::size_t>& t : triangles)
    six_volumes +=
        CGAL::determinant(points[t[0]] - CGAL::ORIGIN, points[t[1]] - CGAL::ORIGIN, points[t[2]] - CGAL::ORIGIN);
  return CGAL::abs(six_volumes) / 6;
}

TriangleMesh random_tetrahedron_for_cgal(Random& random) {
  for (;;) {
    const Vec3 p = random_vector(random, 1), q = random_vector(random, 1), r = random_vector(random, 1),
               s = random_vector(random, 1);
    if (dot(cross(q - p, r - p), s - p) < -0.05) return tetrahedron_mesh(p, q, r, s);
  }
}

TriangleMesh solid_for_cgal(const std::string& family, Random& random) {
  const auto size = [&] { return random.between(0.2, 1); };
  if (family == "boxes") return box_mesh({size(), size(), size()});
  if (family == "spheres") return icosphere_mesh(size(), static_cast<int>(random.below(3)));
  if (family == "prisms") return prism_mesh(size(), 2 * size(), static_cast<int>(3 + random.below(6)));
  if (family == "tetrahedra") return random_tetrahedron_for_cgal(random);
  if (family == "l shapes") return l_mesh();
  static const std::vector<std::string> kinds = {"boxes", "spheres", "prisms", "tetrahedra", "l shapes"};
  return solid_for_cgal(kinds[random.below(kinds.size())], random);
}

/// As it is, or turned anyhow.
Mat3 some_turn(Random& random) { return random.below(4) == 0 ? Mat3{} : random_rotation(random); }

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
                                                2000,
                                                10,
                                                run_volumes_beside_cgal,
                                                200});

}  // namespace
}  // namespace toccata::test
