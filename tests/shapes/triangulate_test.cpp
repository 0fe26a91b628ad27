#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/error_message.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {
namespace {

using test::message_of;
using Triangles = std::vector<std::array<Index, 3>>;

PolygonMesh one_face(std::vector<Vec3> corners) {
  PolygonMesh polygons;
  polygons.corners.resize(corners.size());
  std::iota(polygons.corners.begin(), polygons.corners.end(), 0U);
  polygons.first.push_back(static_cast<Index>(corners.size()));
  polygons.vertices = std::move(corners);
  return polygons;
}

Triangles triangles_of(const std::vector<Vec3>& corners) {
  const TriangleMesh mesh = triangulate(one_face(corners));
  return {mesh.triangles().begin(), mesh.triangles().end()};
}

/// Twice the signed area in the xy-plane; exact for small whole coordinates.
double twice_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double twice_area(const std::vector<Vec3>& polygon) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += twice_area(polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

/// Every triangle turns like the polygon and their areas add up to it: then they cover it once.
void expect_covers(const std::vector<Vec3>& polygon, bool degenerate_allowed = false) {
  const double area = twice_area(polygon);
  const double turn = area < 0 ? -1 : 1;
  const Triangles triangles = triangles_of(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  double sum = 0;
  for (const auto& t : triangles) {
    const double part = twice_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    if (degenerate_allowed)
      EXPECT_GE(part * turn, 0);
    else
      EXPECT_GT(part * turn, 0);
    sum += part;
  }
  EXPECT_EQ(sum, area);
}

/// Whole coordinates, star-shaped around the origin, so simple; many corners are not convex.
std::vector<Vec3> star(Random& random, int corners) {
  std::vector<Vec3> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * i / corners, radius = random.between(2000, 100000);
    polygon.push_back({std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle)), 0});
  }
  return polygon;
}

TEST(Triangulate, TriangleAndConvexQuadrilateral) {
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}}));
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulate, QuadrilateralWithOneCornerPushedIn) {
  std::vector<Vec3> arrow = {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  for (int turn = 0; turn < 4; ++turn) {
    expect_covers(arrow);
    std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
  }
}

TEST(Triangulate, CornersOnALineGiveNoTriangleWithoutArea) {
  expect_covers({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}});
  expect_covers({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 3, 0}, {0, 2, 0}, {0, 1, 0}});
}

TEST(Triangulate, HoleJoinedByABridge) {
  expect_covers(
      {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}, {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}});
}

TEST(Triangulate, RepeatedCornersInARow) {
  expect_covers({{0, 0, 0}, {2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 2, 0}}, true);
}

TEST(Triangulate, RandomStarsInEveryPlaneAndTurn) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Vec3> polygon = star(random, 4 + static_cast<int>(random.below(60)));
    expect_covers(polygon);
    const Triangles flat = triangles_of(polygon);
    std::vector<Vec3> standing, lying;
    for (const Vec3& p : polygon) standing.push_back({0, p.x, p.y}), lying.push_back({p.y, 0, p.x});
    EXPECT_EQ(triangles_of(standing), flat);
    EXPECT_EQ(triangles_of(lying), flat);
    std::reverse(polygon.begin(), polygon.end());
    expect_covers(polygon);
  }
}

TEST(Triangulate, TinyHugeAndFarAwayFacesAreCutAlike) {
  Random random(7);
  const std::vector<Vec3> polygon = star(random, 30);
  const Triangles expected = triangles_of(polygon);
  for (const double scale : {0x1p-1000, 0x1p900}) {
    std::vector<Vec3> other;
    for (const Vec3& p : polygon) other.push_back(scale * p);
    EXPECT_EQ(triangles_of(other), expected) << scale;
  }
  std::vector<Vec3> far;
  for (const Vec3& p : polygon) far.push_back(p + Vec3{0x1p30, 0x1p30, 0x1p30});
  EXPECT_EQ(triangles_of(far), expected);
}

TEST(Triangulate, FacesWithoutProperEarsAreFanned) {
  const std::vector<Vec3> bow_tie = {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(triangles_of(bow_tie), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(triangles_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}),
            (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(triangles_of(std::vector<Vec3>(5)), (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(Triangulate, CombOfManyCornersIsQuick) {
  std::vector<Vec3> comb;
  const int teeth = 2500;
  for (int i = 0; i < teeth; ++i) {
    comb.push_back({4.0 * i, 0, 0});
    comb.push_back({4.0 * i + 1, -1000, 0});
    comb.push_back({4.0 * i + 2, 0, 0});
  }
  comb.push_back({4.0 * teeth, 5, 0});
  comb.push_back({0, 5, 0});
  expect_covers(comb);
}

TEST(Triangulate, KeepsFaceNumbers) {
  PolygonMesh polygons;
  polygons.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  polygons.corners = {0, 1, 2, 0, 1, 2, 3, 0, 2, 3};
  polygons.first = {0, 3, 7, 10};
  const TriangleMesh mesh = triangulate(polygons);
  ASSERT_EQ(mesh.triangle_count(), 4U);
  EXPECT_EQ(mesh.face_count(), 3U);
  EXPECT_EQ((std::array{mesh.face_of(0), mesh.face_of(1), mesh.face_of(2), mesh.face_of(3)}),
            (std::array<Index, 4>{0, 1, 1, 2}));
}

TEST(Triangulate, ErrorsNameTheFace) {
  PolygonMesh polygons = one_face({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  polygons.corners.insert(polygons.corners.end(), {0, 1});
  polygons.first.push_back(5);
  EXPECT_EQ(message_of([&] { (void)triangulate(polygons); }), "face 1 has fewer than three corners");
  polygons.corners.push_back(9);
  polygons.first.back() = 6;
  EXPECT_EQ(message_of([&] { (void)triangulate(polygons); }),
            "face 1 names vertex 9, but there are 3 vertices, counted from 0");
  EXPECT_THROW((void)triangulate({}), Error);
}

TEST(TriangleMesh, RefusesWhatIsNotAMesh) {
  const std::vector<Vec3> vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_NE(message_of([&] { TriangleMesh({{0, 0, std::nan("")}}, {{0, 0, 0}}); }).find("vertex 0"), std::string::npos);
  EXPECT_NE(message_of([&] {
              TriangleMesh(vertices, {{0, 1, 3}});
            }).find("triangle 0 names vertex 3"),
            std::string::npos);
  EXPECT_NE(message_of([&] { TriangleMesh(vertices, {}); }).find("at least one"), std::string::npos);
  EXPECT_THROW(TriangleMesh(vertices, {{0, 1, 2}}, {0, 1}), Error);
  EXPECT_THROW(TriangleMesh(vertices, {{0, 1, 2}, {0, 1, 2}}, {1, 0}), Error);
}

TEST(Triangulate, RefusesAFaceThatWouldTakeHours) {
  std::vector<Vec3> corners;
  for (Index i = 0; i <= most_face_corners; ++i) corners.push_back({static_cast<double>(i), (i % 2) * 1.0, 0});
  EXPECT_THROW(static_cast<void>(triangulate(one_face(corners))), Error);
}

}  // namespace
}  // namespace toccata
