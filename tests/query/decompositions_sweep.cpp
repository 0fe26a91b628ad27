// Convex parts of solids of unit cubes: that they contain every cube is told by exact signs, without the queries.
#include <algorithm>

#include "support/case_seeds.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/query/convex_parts.hpp"

namespace toccata::test {
namespace {

bool is_behind_every_face(const ConvexHull& hull, const Vec3& point) {
  if (hull.dimension() < 3) return false;
  const HullTopology topology = hull.topology();
  for (Index f = 0; f < topology.face_count(); ++f) {
    const Index h = topology.face_start[f];
    const auto corner = [&](Index i) { return hull.vertex(topology.origin[h + i]); };
    if (orient3d(corner(0), corner(1), corner(2), point) == Sign::positive) return false;
  }
  return true;
}

bool is_in_some(const ConvexParts& parts, const Vec3& point) {
  return std::ranges::any_of(parts.parts,
                             [&](const ConvexPart& part) { return is_behind_every_face(part.hull, point); });
}

std::string fault_of_decomposition(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const VoxelSolid solid = random_voxels(random, 8, 3);
  const Skin skin = family == "every-face" ? Skin::every : family == "inside-out" ? Skin::inside_out : Skin::outer;
  TriangleMesh mesh = mesh_of(solid, skin, random);
  // Turned by general numbers the corners of cuts are no doubles; sums of products round, so the oracle's points must
  // lie well within their cubes.
  Pose pose;
  if (family == "turned")
    for (int row = 0; row < 3; ++row)
      for (int axis = 0; axis < 3; ++axis) pose.linear[row][axis] = random.between(-1, 1);
  if (is_singular(pose.linear)) return "";
  mesh = mesh.with_vertices(transform(pose, mesh.vertices()));
  const std::size_t most = 1 + random.below(8);
  const ConvexParts parts = decompose(mesh, {.max_parts = most});
  if (parts.parts.empty() || parts.parts.size() > most) return "another number of parts than was allowed";
  for (const ConvexPart& part : parts.parts)
    for (Index v = 0; v < part.hull.vertex_count(); ++v)
      if (part.hull.dimension() == 3 && !is_behind_every_face(part.hull, part.hull.vertex(v)))
        return "a part that is not convex";
  for (const Vec3& vertex : mesh.vertices())
    if (!is_in_some(parts, vertex)) return "a vertex in no part";
  for (const Voxel& voxel : solid)
    for (int i = 0; i < 8; ++i) {
      const auto inside = [&](std::size_t axis) { return voxel[axis] + random.between(0.001, 0.999); };
      if (!is_in_some(parts, transform(pose, Vec3{inside(0), inside(1), inside(2)})))
        return "a point of the solid in no part";
    }
  return "";
}

SweepResult run_decompositions(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases,
                   [&](std::uint64_t case_seed) { return fault_of_decomposition(family, case_seed); });
}

const bool decompositions_known = register_sweep(
    {"decompositions", {"upright", "every-face", "inside-out", "turned"}, 4'000, 10, run_decompositions, 500, 3});

}  // namespace
}  // namespace toccata::test
