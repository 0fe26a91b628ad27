#include "narrow/convex/edge_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/shapes/convex_hull.hpp"

// Walks along the edges against scans of all vertices: the same answers, or none.
namespace toccata {
namespace {

Vec3 random_direction(Random& random) {
  const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
  return {x, y, z};
}

std::vector<Vec3> ball(int count) {
  Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const Vec3 v = random_direction(random);
    points.push_back((1 / std::hypot(v.x, v.y, v.z)) * v);
  }
  return points;
}

/// A polygon of whole numbers of a large circle, which is regular but for rounding, at a height.
void add_polygon(int corners, double height, std::vector<Vec3>& points) {
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / corners;
    points.push_back({std::cos(angle), std::sin(angle), height});
  }
}

std::vector<Vec3> prism(int corners) {
  std::vector<Vec3> points;
  add_polygon(corners, -1, points);
  add_polygon(corners, 1, points);
  return points;
}

std::vector<Vec3> cone(int corners) {
  std::vector<Vec3> points;
  add_polygon(corners, 0, points);
  points.push_back({0.1, 0.2, 1});
  return points;
}

std::vector<Vec3> polygon(int corners) {
  std::vector<Vec3> points;
  add_polygon(corners, 0.5, points);
  return points;
}

/// A ball, stretched along an axis; its vertices are a last place apart across it.
std::vector<Vec3> needle(int count) {
  std::vector<Vec3> points = ball(count);
  for (Vec3& p : points) p = {p.x, 1 + 0x1p-45 * p.y, 1 + 0x1p-45 * p.z};
  return points;
}

std::vector<Vec3> scaled(std::vector<Vec3> points, double factor) {
  for (Vec3& p : points) p = factor * p;
  return points;
}

struct Case {
  std::string name;
  std::vector<Vec3> points;
};

std::vector<Case> cases() {
  return {{"ball", ball(1000)},
          {"small ball", ball(40)},
          {"prism", prism(300)},
          {"cone", cone(700)},
          {"polygon", polygon(400)},
          {"needle", needle(600)},
          {"segment", {{0, 0, 0}, {1, 2, 3}}},
          {"point", {{1, 2, 3}}},
          {"tiny ball", scaled(ball(600), 1e-300)},
          {"subnormal ball", scaled(ball(600), 1e-310)},
          {"huge ball", scaled(ball(600), 1e150)},
          {"greatest ball", scaled(ball(600), 1e308)}};
}

/// Directions of all sorts; those across an edge or a face have many vertices at nearly the same height.
std::vector<Vec3> directions(const ConvexHull& hull, Random& random) {
  std::vector<Vec3> all{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {1e-320, 0, 0}, {1e300, 1e300, 0}};
  for (int i = 0; i < 20; ++i) all.push_back(random_direction(random));
  const HullTopology t = hull.topology();
  for (Index face = 0; face < t.face_count() && face < 15; ++face) {
    const Index edge = t.face_start[face];
    if (t.face_start[face + 1] - edge < 3) continue;
    const Vec3 p = hull.vertex(t.origin[edge]), q = hull.vertex(t.origin[edge + 1]);
    all.push_back(cross(q - p, hull.vertex(t.origin[edge + 2]) - p));
    all.push_back(cross(q - p, random_direction(random)));
  }
  return all;
}

SupportScan scan_of(const PosedPolytope& shape, const Vec3& direction) {
  return {shape.along(0), shape.along(1), shape.along(2), shape.padded_count(), direction, {}, shape.vertex_count()};
}

TEST(EdgeWalk, FindsWhatAScanOfAllVerticesFinds) {
  const SupportKernels kernels = support_kernels();
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const ConvexHull hull(one.points);
    const PosedPolytope shape(hull);
    Random random(5);
    int answers = 0;
    for (const Vec3& direction : directions(hull, random)) {
      const auto start = static_cast<Index>(random.below(hull.vertex_count()));
      SupportScan scan = scan_of(shape, direction);
      if (const auto least = EdgeWalk(shape, scan).least(start)) {
        ++answers;
        EXPECT_EQ(*least, kernels.least(scan));
      }
      scan.spread = 0x1p-48 * Vec3{1, 1, 1};
      if (const auto depth = EdgeWalk(shape, scan).least_depth(start)) {
        EXPECT_EQ(*depth, kernels.least_depth(scan));
      }
      const double bound = kernels.least_depth(scan) + random.unit() * 0x1p-45 * one.points[0].x;
      const std::array<Index, 2> own{kernels.least(scan), start};
      std::array<Index, 4> found{}, expected{};
      if (const auto count = EdgeWalk(shape, scan).close(bound, own, found, start)) {
        EXPECT_EQ(*count, kernels.close(scan, bound, own, expected));
        EXPECT_EQ(found, expected);
      }
    }
    EXPECT_GT(answers, one.name == "ball" ? 40 : -1);
  }
}

TEST(EdgeWalk, LooksAtFewVertices) {
  const ConvexHull hull(ball(4000));
  const PosedPolytope shape(hull);
  Random random(5);
  std::uint64_t heights = 0;
  for (int i = 0; i < 100; ++i) {
    const SupportScan scan = scan_of(shape, random_direction(random));
    EdgeWalk walk(shape, scan);
    EXPECT_TRUE(walk.least(static_cast<Index>(random.below(hull.vertex_count()))).has_value());
    heights += walk.heights();
  }
  EXPECT_LT(heights, 100U * 40);
}

}  // namespace
}  // namespace toccata
