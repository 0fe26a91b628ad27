#include "query/world_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/mesh_soups.hpp"

namespace toccata {
namespace {

std::vector<Index> near(const PosedMesh& mesh, const Aabb& region) {
  std::vector<Index> found;
  visit_triangles_near(mesh, region, [&](Index triangle) {
    found.push_back(triangle);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> near_by_brute_force(const PosedMesh& mesh, const Aabb& region) {
  std::vector<Index> found;
  for (Index i = 0; i < mesh.model().mesh().triangle_count(); ++i)
    if (overlap(box_of(mesh.triangle(i)), region)) found.push_back(i);
  return found;
}

TEST(WorldSearch, AsBruteForceForBoxesAndRays) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      const Pose pose = test::random_poses(family, random).pose_a;
      const PosedMesh mesh(Model(test::random_soup(random, 40, 0.2, seed % 2 == 0 ? 4 : 0)), pose);
      // Corners at vertices, so that many boxes touch exactly.
      const auto vertex = [&] { return mesh.vertices()[random.below(mesh.vertices().size())]; };
      const Aabb region = merge(merge(Aabb{}, vertex()), vertex());
      EXPECT_EQ(near(mesh, region), near_by_brute_force(mesh, region));
      for (int axis = 0; axis < 3; ++axis) {
        Aabb ray = merge(Aabb{}, vertex());
        ray.upper[axis] = std::numeric_limits<double>::infinity();
        EXPECT_EQ(near(mesh, ray), near_by_brute_force(mesh, ray));
      }
    }
}

TEST(WorldSearch, EndsWhenToldTo) {
  const PosedMesh mesh(Model(test::box_mesh({0, 0, 0}, {1, 1, 1})), Pose{});
  int visited = 0;
  visit_triangles_near(mesh, mesh.box(), [&](Index) { return ++visited < 3; });
  EXPECT_EQ(visited, 3);
}

TEST(WorldSearch, AnEmptyRegionHasNoTriangles) {
  const PosedMesh mesh(Model(test::box_mesh({0, 0, 0}, {1, 1, 1})), Pose{});
  EXPECT_TRUE(near(mesh, Aabb{}).empty());
}

}  // namespace
}  // namespace toccata
