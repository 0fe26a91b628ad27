#include "query/meshes/world_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <variant>

#include "math/vec3_measures.hpp"
#include "query/posed_shape.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/generate/meshes.hpp"

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

/// What a ray through a vertex certainly meets.
std::vector<Index> triangles_with(const PosedMesh& mesh, const Vec3& vertex) {
  std::vector<Index> found;
  for (Index i = 0; i < mesh.model().mesh().triangle_count(); ++i) {
    const Triangle t = mesh.triangle(i);
    if (std::count(t.vertex.begin(), t.vertex.end(), vertex) > 0) found.push_back(i);
  }
  return found;
}

Vec3 random_vertex(const PosedMesh& mesh, Random& random) {
  return mesh.triangle(static_cast<Index>(random.below(mesh.model().mesh().triangle_count())))[0];
}

bool is_subset(const std::vector<Index>& part, const std::vector<Index>& of) {
  return std::includes(of.begin(), of.end(), part.begin(), part.end());
}

/// Each case touches a vertex exactly; the tree may show more, and must not lose what meets.
TEST(WorldSearch, NothingThatMeetsAHalfSpaceIsLost) {
  std::size_t shown = 0, all = 0;
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      const Pose pose = test::random_poses(family, random).pose_a;
      const PosedMesh mesh(Model(test::random_soup(random, 40, 0.2, seed % 2 == 0 ? 4 : 0)), pose);
      const double length = seed % 3 == 0 ? 1e-200 : seed % 3 == 1 ? 1e200 : 1;
      const Vec3 normal = seed % 2 == 0 ? Vec3{0, 0, length}
                                        : Vec3{length * random.between(-1, 1), length * random.between(-1, 1), length};
      const PosedHalfSpace below(HalfSpace(random_vertex(mesh, random), normal));
      std::vector<Index> visited, meeting;
      visit_triangles_near(mesh, below, [&](Index triangle) {
        visited.push_back(triangle);
        return true;
      });
      for (Index i = 0; i < mesh.model().mesh().triangle_count(); ++i)
        if (overlap(PosedPolytope(mesh.triangle(i)), below)) meeting.push_back(i);
      std::sort(visited.begin(), visited.end());
      EXPECT_TRUE(is_subset(meeting, visited));
      EXPECT_FALSE(meeting.empty());
      shown += visited.size();
      all += mesh.model().mesh().triangle_count();
    }
  EXPECT_LT(shown, all * 3 / 4) << "the tree tells few apart";
}

/// Through or beside a vertex of the mesh, long and thin or flat, and across the axes.
std::variant<PosedPolytope, PosedQuadric> thin_body(const Vec3& at, double size, Random& random) {
  const Vec3 way = test::random_vector(random, size), across = test::random_vector(random, size);
  Pose pose{test::random_rotation(random), at};
  switch (random.below(7)) {
    case 0:
      return PosedPolytope(Segment{at - way, at + way});
    case 1:
      return PosedPolytope(Segment{at, at + way});
    case 2:
      return PosedPolytope(Triangle{{at - way, at + way, at + across}});
    case 3:
      return PosedPolytope(Capsule({-size, 0, 0}, {size, 0, 0}, 0.01 * size), pose);
    case 4:
      return PosedPolytope(Box({size, 0.01 * size, 0.02 * size}), pose);
    case 5:
      return PosedQuadric(Cylinder(0.01 * size, size), pose);
    default:
      pose.linear[0] = pose.linear[0] + 0.2 * pose.linear[1];  // no rotation
      return PosedQuadric(Ellipsoid({0.01 * size, size, size}), pose);
  }
}

TEST(WorldSearch, NothingThatMeetsAThinBodyIsLost) {
  std::size_t shown = 0, of_boxes = 0, meeting = 0;
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      const Pose pose = test::random_poses(family, random).pose_a;
      const PosedMesh mesh(Model(test::random_soup(random, 40, 0.2, seed % 2 == 0 ? 4 : 0)), pose);
      const Aabb& all = mesh.box();
      const double size = random.between(0.05, 1) * largest_magnitude(all.upper - all.lower);
      const auto body = thin_body(random_vertex(mesh, random), size, random);
      std::visit(
          [&](const auto& posed) {
            const Aabb box = world_box(posed);
            std::vector<Index> visited;
            visit_triangles_near(mesh, box, ranges_of(posed, box), [&](Index triangle) {
              visited.push_back(triangle);
              return true;
            });
            std::sort(visited.begin(), visited.end());
            for (Index i = 0; i < mesh.model().mesh().triangle_count(); ++i) {
              if (!overlap(PosedPolytope(mesh.triangle(i)), posed)) continue;
              ++meeting;
              EXPECT_TRUE(std::binary_search(visited.begin(), visited.end(), i)) << i;
            }
            shown += visited.size();
            of_boxes += near(mesh, box).size();
          },
          body);
    }
  EXPECT_GT(meeting, 60U);
  EXPECT_LT(shown, of_boxes / 2) << "the directions tell few apart";
}

/// Its box holds half of the mesh, and it is near to a few triangles.
TEST(WorldSearch, ASegmentAcrossAFineMeshLooksAtFewTriangles) {
  const PosedMesh mesh(Model(icosphere_mesh(1, 5)), {});
  const PosedPolytope segment(Segment{{-1, -1, -1}, {1, 1, 1}});
  const Aabb box = world_box(segment);
  std::size_t seen = 0;
  visit_triangles_near(mesh, box, ranges_of(segment, box), [&](Index) {
    ++seen;
    return true;
  });
  EXPECT_GE(seen, 2U);
  EXPECT_LE(seen, 40U) << "of " << mesh.model().mesh().triangle_count();
}

TEST(WorldSearch, AsBruteForceForBoxes) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      const Pose pose = test::random_poses(family, random).pose_a;
      const PosedMesh mesh(Model(test::random_soup(random, 40, 0.2, seed % 2 == 0 ? 4 : 0)), pose);
      // Corners at vertices, so that many boxes touch exactly.
      const Vec3 corner = random_vertex(mesh, random);
      const Aabb region = merge(merge(Aabb{}, corner), random_vertex(mesh, random));
      EXPECT_EQ(near(mesh, region), near_by_brute_force(mesh, region));
    }
}

TEST(WorldSearch, MissesNothingThatARayMeets) {
  for (const std::string& family : test::pose_families())
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(family + ", seed " + std::to_string(seed));
      Random random(seed);
      const Pose pose = test::random_poses(family, random).pose_a;
      const PosedMesh mesh(Model(test::random_soup(random, 40, 0.2, seed % 2 == 0 ? 4 : 0)), pose);
      for (int i = 0; i < 60; ++i) {
        const Vec3 vertex = random_vertex(mesh, random);
        const int axis = i % 3;
        Aabb ray{vertex, vertex};
        ray.lower[axis] -= random.below(2) == 0 ? 0 : random.unit();
        ray.upper[axis] = std::numeric_limits<double>::infinity();
        const std::vector<Index> found = near(mesh, ray);
        EXPECT_TRUE(is_subset(triangles_with(mesh, vertex), found));
        EXPECT_TRUE(is_subset(found, near_by_brute_force(mesh, ray)));
      }
    }
}

/// Long parallel triangles at 45°: the world boxes of all of them meet the ray.
TEST(WorldSearch, LooksOnlyAtWhatLiesBesideARay) {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < 100; ++i) {
    vertices.insert(vertices.end(), {{i / 100.0, 0, 0}, {i / 100.0, 10, 0}, {i / 100.0, 10, 1}});
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Pose turned{Mat3{{Vec3{1, -1, 0}, Vec3{1, 1, 0}, Vec3{0, 0, 1}}}, {}};
  const PosedMesh mesh(Model(TriangleMesh(vertices, triangles)), turned);
  Aabb ray = merge(Aabb{}, Vec3{-4.5, 5.5, -1});
  ray.upper.z = std::numeric_limits<double>::infinity();
  EXPECT_GT(near_by_brute_force(mesh, ray).size(), 90U);
  EXPECT_LT(near(mesh, ray).size(), 10U);
}

TEST(WorldSearch, EndsWhenToldTo) {
  const PosedMesh mesh(Model(test::box_between({0, 0, 0}, {1, 1, 1})), Pose{});
  int visited = 0;
  visit_triangles_near(mesh, mesh.box(), [&](Index) { return ++visited < 3; });
  EXPECT_EQ(visited, 3);
}

TEST(WorldSearch, AnEmptyRegionHasNoTriangles) {
  const PosedMesh mesh(Model(test::box_between({0, 0, 0}, {1, 1, 1})), Pose{});
  EXPECT_TRUE(near(mesh, Aabb{}).empty());
}

}  // namespace
}  // namespace toccata
