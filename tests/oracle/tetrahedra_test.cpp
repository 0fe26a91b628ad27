// A tetrahedron is a mesh and a convex hull, whatever its vertices: two parts of the oracle that share no method.
#include <gtest/gtest.h>

#include <array>

#include "oracle/oracle.hpp"
#include "toccata/core/random.hpp"

namespace toccata::oracle {
namespace {

using Corners = std::array<Vec3, 4>;

/// Multiples of 1, so that many touch, or any doubles.
Corners random_corners(Random& random, bool on_grid) {
  Corners corners{};
  for (Vec3& v : corners)
    for (int axis = 0; axis < 3; ++axis)
      v[axis] = on_grid ? static_cast<double>(random.below(4)) : random.between(0, 2);
  return corners;
}

TriangleMesh tetrahedron(const Corners& v) {
  return TriangleMesh({v[0], v[1], v[2], v[3]}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

TriangleMesh triangle(const Corners& v) { return TriangleMesh({v[0], v[1], v[2]}, {{0, 1, 2}}); }

TEST(OracleTetrahedra, MeshAndHullLieAlike) {
  const std::uint64_t seed = 31;
  Random random(seed);
  int compared = 0;
  for (int round = 0; round < 60; ++round) {
    const bool on_grid = round % 3 != 0;
    const Corners a = random_corners(random, on_grid);
    const Corners b = random_corners(random, on_grid);
    const ConvexSet hull_a = hull_set(a);
    const ConvexSet hull_b = hull_set(b);
    if (!is_solid(hull_a) || !is_solid(hull_b)) continue;
    ++compared;
    const MeshSet mesh_a = solid_set(tetrahedron(a), {});
    const MeshSet mesh_b = solid_set(tetrahedron(b), {});
    EXPECT_EQ(relation(mesh_a, mesh_b), relation(hull_a, hull_b)) << "seed " << seed << " round " << round;
    EXPECT_EQ(squared_distance(mesh_a, mesh_b), nearest_points(hull_a, hull_b).squared_distance)
        << "seed " << seed << " round " << round;
  }
  EXPECT_GT(compared, 30);
}

TEST(OracleTetrahedra, ATriangleAndATetrahedronLieAlike) {
  const std::uint64_t seed = 32;
  Random random(seed);
  for (int round = 0; round < 60; ++round) {
    const bool on_grid = round % 3 != 0;
    const Corners a = random_corners(random, on_grid);
    const Corners b = random_corners(random, on_grid);
    const ConvexSet hull_b = hull_set(b);
    if (!is_solid(hull_b)) continue;
    EXPECT_EQ(relation(surface_set(triangle(a), {}), solid_set(tetrahedron(b), {})),
              relation(triangle_set(a[0], a[1], a[2]), hull_b))
        << "seed " << seed << " round " << round;
  }
}

TEST(OracleTetrahedra, PointsLieAlike) {
  const std::uint64_t seed = 33;
  Random random(seed);
  for (int round = 0; round < 200; ++round) {
    const Corners corners = random_corners(random, round % 3 != 0);
    const ConvexSet hull = hull_set(corners);
    if (!is_solid(hull)) continue;
    const RationalPoint p = exact(random_corners(random, round % 2 != 0)[0]);
    const Location location = locate(p, solid_set(tetrahedron(corners), {}));
    const int side = location.on_face ? 0 : location.winding_number == 0 ? 1 : -1;
    EXPECT_EQ(side, side_of(p, hull)) << "seed " << seed << " round " << round;
  }
}

}  // namespace
}  // namespace toccata::oracle
