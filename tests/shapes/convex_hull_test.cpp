#include "toccata/shapes/convex_hull.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "shapes/hull_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {
namespace {

using test::hull_failure;
using test::hull_points;

std::vector<Vec3> cube() {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
  return corners;
}

std::vector<Index> face_of(const HullTopology& t, Index f) {
  return {t.origin.begin() + t.face_start[f], t.origin.begin() + t.face_start[f + 1]};
}

TEST(ConvexHull, OfACubeHasSixFacesInCanonicalOrder) {
  std::vector<Vec3> points = cube();
  points.push_back({0.5, 0.5, 0.5});  // inside
  points.push_back({0.5, 0.5, 1});    // within a face
  points.push_back({0.5, 0, 0});      // within an edge
  const ConvexHull hull(points);
  EXPECT_EQ(hull_failure(hull, points), "");
  EXPECT_EQ(hull.vertex_count(), 8U);
  EXPECT_EQ(hull.dimension(), 3);
  const HullTopology t = hull.topology();
  ASSERT_EQ(t.face_count(), 6U);
  EXPECT_EQ(face_of(t, 0), (std::vector<Index>{0, 1, 5, 4}));
  EXPECT_EQ(face_of(t, 1), (std::vector<Index>{0, 2, 3, 1}));
  EXPECT_EQ(face_of(t, 5), (std::vector<Index>{4, 5, 7, 6}));
}

TEST(ConvexHull, KeepsTheOrderOfThePoints) {
  std::vector<Vec3> points{{0.5, 0.25, 0.25}};
  for (const Vec3& corner : cube()) {
    points.push_back(corner);
    points.push_back(corner);
  }
  const ConvexHull hull(points);
  ASSERT_EQ(hull.vertex_count(), 8U);
  for (Index v = 0; v < 8; ++v) EXPECT_EQ(hull.source_of(v), 1 + 2 * v);
}

TEST(ConvexHull, TakesItsPointsAsAList) {
  EXPECT_EQ(ConvexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).dimension(), 3);
  EXPECT_EQ(ConvexHull({{0, 0, 0}, {1, 0, 0}}).dimension(), 1);
  EXPECT_EQ(ConvexHull({{1, 2, 3}}).vertex_count(), 1U);
}

TEST(ConvexHull, MayBeFlat) {
  const ConvexHull point(std::vector<Vec3>{{1, 2, 3}, {1, 2, 3}});
  EXPECT_EQ(point.dimension(), 0);
  EXPECT_EQ(point.topology().face_count(), 0U);
  EXPECT_EQ(point.padded_coordinates(2).size(), 8U);

  const ConvexHull segment(std::vector<Vec3>{{1, 1, 1}, {0, 0, 0}, {3, 3, 3}, {2, 2, 2}});
  EXPECT_EQ(segment.dimension(), 1);
  EXPECT_EQ(segment.source_of(0), 1U);
  EXPECT_EQ(segment.source_of(1), 2U);
  EXPECT_EQ(segment.topology().twin[0], 1U);

  const ConvexHull square(std::vector<Vec3>{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {1, 1, 1}});
  EXPECT_EQ(square.dimension(), 2);
  EXPECT_EQ(square.vertex_count(), 4U);
  EXPECT_EQ(face_of(square.topology(), 0), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(face_of(square.topology(), 1), (std::vector<Index>{0, 3, 2, 1}));
}

TEST(ConvexHull, OneLastPlaceIsNotFlat) {
  std::vector<Vec3> points{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  EXPECT_EQ(ConvexHull(points).dimension(), 2);
  points[2].z = std::nextafter(1.0, 2.0);
  const ConvexHull hull(points);
  EXPECT_EQ(hull.dimension(), 3);
  EXPECT_EQ(hull.topology().face_count(), 4U);
}

TEST(ConvexHull, RefusesWhatIsNoHull) {
  EXPECT_THROW(ConvexHull(std::vector<Vec3>{}), Error);
  EXPECT_THROW(ConvexHull(std::vector<Vec3>(most_hull_points + 1U)), Error);
  std::vector<Vec3> points = cube();
  points[3].y = std::numeric_limits<double>::quiet_NaN();
  try {
    const ConvexHull hull(points);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("point 3"), std::string::npos) << error.what();
  }
}

TEST(ConvexHull, IsThatOfItsPointsInEveryFamily) {
  for (const std::string& family : test::hull_families())
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      Random random(seed);
      const std::size_t count = 1 + random.below(seed % 4 == 0 ? 300 : 30);
      const std::vector<Vec3> points = hull_points(family, random, count);
      const ConvexHull hull(points);
      ASSERT_EQ(hull_failure(hull, points), "") << family << " seed " << seed << ": " << test::to_text(points);
    }
}

TEST(ConvexHull, DoesNotDependOnTheOrderOfThePoints) {
  for (const std::string& family : test::hull_families())
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Random random(seed);
      const std::vector<Vec3> points = hull_points(family, random, 60);
      const ConvexHull hull(points);
      // The vertices alone, in their order, have the same hull, to the last index.
      std::vector<Vec3> vertices;
      for (Index v = 0; v < hull.vertex_count(); ++v) vertices.push_back(hull.vertex(v));
      std::vector<Vec3> with_others = vertices;
      with_others.insert(with_others.end(), points.rbegin(), points.rend());
      for (const auto& same : {vertices, with_others}) {
        const ConvexHull again(same);
        ASSERT_TRUE(std::ranges::equal(again.topology().origin, hull.topology().origin)) << family << " seed " << seed;
        ASSERT_TRUE(std::ranges::equal(again.topology().twin, hull.topology().twin)) << family << " seed " << seed;
        ASSERT_TRUE(std::ranges::equal(again.topology().face_start, hull.topology().face_start));
      }
    }
}

TEST(ConvexHull, TakesLessThan128BytesAVertex) {
  for (const std::size_t count : {4U, 5U, 9U, 12U, 17U, 100U, 1000U}) {
    Random random(count);
    const ConvexHull hull(hull_points("sphere", random, count));
    EXPECT_EQ(hull.vertex_count(), count);
    EXPECT_LT(hull.memory(), 128 * count) << count;
  }
}

TEST(ConvexHullSlow, OfManyPoints) {
  for (const char* family : {"ball", "sphere", "near-coplanar", "grid"}) {
    Random random(7);
    const std::vector<Vec3> points = hull_points(family, random, 20'000);
    EXPECT_EQ(hull_failure(ConvexHull(points), points, 100), "") << family;
  }
}

/// Two polygons of so many corners that one that is done before the other makes it slow.
TEST(ConvexHullSlow, OfALongPrism) {
  std::vector<Vec3> points;
  constexpr int corners = 10'000;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners;
    for (const double z : {0.0, 1.0}) points.push_back({std::cos(angle), std::sin(angle), z});
  }
  const ConvexHull hull(points);
  EXPECT_EQ(hull_failure(hull, points, 50), "");
  EXPECT_EQ(hull.vertex_count(), points.size());
}

std::string message_of_convex_mesh(const TriangleMesh& mesh) {
  try {
    (void)hull_of_convex_mesh(mesh);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// A hull's faces as fans.
TriangleMesh mesh_of(const ConvexHull& hull) {
  std::vector<Vec3> vertices;
  for (Index v = 0; v < hull.vertex_count(); ++v) vertices.push_back(hull.vertex(v));
  const HullTopology t = hull.topology();
  std::vector<std::array<Index, 3>> triangles;
  for (Index f = 0; f < t.face_count(); ++f)
    for (Index h = t.face_start[f] + 1; h + 1 < t.face_start[f + 1]; ++h)
      triangles.push_back({t.origin[t.face_start[f]], t.origin[h], t.origin[h + 1]});
  return TriangleMesh(vertices, triangles);
}

TriangleMesh changed(const TriangleMesh& mesh, const std::function<void(std::vector<std::array<Index, 3>>&)>& change) {
  std::vector<std::array<Index, 3>> triangles(mesh.triangles().begin(), mesh.triangles().end());
  change(triangles);
  return TriangleMesh({mesh.vertices().begin(), mesh.vertices().end()}, triangles);
}

TEST(HullOfConvexMesh, TakesEveryHullsBoundary) {
  for (const char* family : {"ball", "sphere", "coarse-grid", "near-coplanar", "needle", "huge"})
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      Random random(seed);
      const ConvexHull hull(hull_points(family, random, 40));
      ASSERT_EQ(hull.dimension(), 3);
      const ConvexHull again = hull_of_convex_mesh(mesh_of(hull));
      ASSERT_TRUE(std::ranges::equal(again.topology().origin, hull.topology().origin)) << family << " seed " << seed;
    }
}

TEST(HullOfConvexMesh, SaysWhatIsWrong) {
  const TriangleMesh box = mesh_of(ConvexHull(cube()));
  EXPECT_EQ(message_of_convex_mesh(box), "");
  const std::string open = message_of_convex_mesh(changed(box, [](auto& t) { t.pop_back(); }));
  EXPECT_NE(open.find("face 4 has an edge"), std::string::npos) << open;
  const TriangleMesh inside_out = changed(box, [](auto& triangles) {
    for (auto& t : triangles) std::swap(t[1], t[2]);
  });
  EXPECT_EQ(message_of_convex_mesh(inside_out),
            "the mesh is not a convex solid: face 0 turns clockwise seen from outside; turn all faces round");
  const TriangleMesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_NE(message_of_convex_mesh(flat).find("flat"), std::string::npos);
  EXPECT_NE(message_of_convex_mesh(generate_mesh("torus-knot")).find(" before it"), std::string::npos);
}

TEST(HullOfConvexMesh, OneLastPlaceIsADent) {
  const std::vector<Vec3> corners = cube();
  const auto pyramid_on_cube = [&](double height) {
    TriangleMesh box = mesh_of(ConvexHull(corners));
    std::vector<Vec3> vertices(box.vertices().begin(), box.vertices().end());
    vertices.push_back({0.5, 0.5, height});
    std::vector<std::array<Index, 3>> triangles;
    for (const auto& t : box.triangles())
      if (!(vertices[t[0]].z == 1 && vertices[t[1]].z == 1 && vertices[t[2]].z == 1)) triangles.push_back(t);
    for (const auto& [from, to] : {std::pair{4, 5}, {5, 7}, {7, 6}, {6, 4}})
      triangles.push_back({static_cast<Index>(from), static_cast<Index>(to), 8});
    return TriangleMesh(vertices, triangles);
  };
  EXPECT_EQ(hull_of_convex_mesh(pyramid_on_cube(1)).vertex_count(), 8U);
  EXPECT_EQ(hull_of_convex_mesh(pyramid_on_cube(std::nextafter(1.0, 2.0))).vertex_count(), 9U);
  EXPECT_NE(message_of_convex_mesh(pyramid_on_cube(std::nextafter(1.0, 0.0))), "");
}

}  // namespace
}  // namespace toccata
