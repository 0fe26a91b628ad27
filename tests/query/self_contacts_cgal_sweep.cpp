// A mesh against itself: CGAL's Polygon_mesh_processing::self_intersections, where it takes the mesh.
#include <fmt/format.h>

#include <cmath>

#include "query/self_cgal.hpp"
#include "support/mesh_soups.hpp"
#include "support/sweep.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata::test {
namespace {

/// A closed or open surface with its vertices moved, so that it meets itself now and then.
TriangleMesh shaken_mesh(const std::string& family, Random& random) {
  const bool is_sphere = random.below(2) == 0;
  const TriangleMesh smooth = is_sphere ? icosphere_mesh(1, static_cast<int>(random.below(3)))
                                        : torus_mesh({.radius = 1, .tube_radius = 0.4, .around = 9, .sides = 6});
  const double noise = random.between(0, 0.4), grid = family == "snapped" ? 16 : 0;
  std::vector<Vec3> vertices(smooth.vertices().begin(), smooth.vertices().end());
  for (Vec3& v : vertices) {
    v = v + Vec3{random.between(-noise, noise), random.between(-noise, noise), random.between(-noise, noise)};
    if (family == "flattened") v.z = 0.25 * std::round(v.z);
    if (grid != 0) v = {std::round(v.x * grid) / grid, std::round(v.y * grid) / grid, std::round(v.z * grid) / grid};
  }
  std::vector<std::array<Index, 3>> corners(smooth.triangles().begin(), smooth.triangles().end());
  if (random.below(2) == 0) corners.resize(corners.size() / 2);
  return {std::move(vertices), std::move(corners)};
}

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(seed);
  while (result.cases < cases) {
    const TriangleMesh mesh = shaken_mesh(family, random);
    const auto& families = pose_families();
    const Pose pose = random_poses(families[random.below(families.size())], random).pose_a;
    const std::optional<CgalSurface> surface = surface_of(mesh, pose);
    if (!surface) continue;
    ++result.cases;
    const TrianglePairs expected = pairs_by_cgal(*surface), found = pairs_by_toccata(mesh, pose);
    if (found != expected && result.wrong++ == 0)
      result.first_failure =
          fmt::format("seed {} case {}: {} pairs, CGAL finds {}", seed, result.cases, found.size(), expected.size());
  }
  return result;
}

const bool known = register_sweep({"self-contacts-cgal", {"shaken", "snapped", "flattened"}, 20'000, 40, run});

}  // namespace
}  // namespace toccata::test
