// Polygons with holes, cut into triangles.
#include "shapes/cut_loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "toccata/core/random.hpp"

namespace toccata {
namespace {

/// Loops in the making.
struct Drawing {
  std::vector<Vec2> points;
  std::vector<CornerLoop> loops;

  /// Counter-clockwise; a hole where `count` is negative.
  void add_ring(const Vec2& middle, double radius, int count, double turned = 0) {
    CornerLoop loop;
    for (int i = 0; i < std::abs(count); ++i) {
      const double angle = turned + 2 * std::numbers::pi * i / count;
      loop.push_back(static_cast<Index>(points.size()));
      points.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
    }
    loops.push_back(loop);
  }

  [[nodiscard]] double area() const {
    double sum = 0;
    for (const CornerLoop& loop : loops) sum += loop_area(points, loop);
    return sum;
  }
};

/// Every triangle turns left, they have the area of the drawing, and their border is that of the loops.
void expect_cut(const Drawing& drawing) {
  const auto triangles = cut_loops(drawing.points, drawing.loops, 0);
  ASSERT_TRUE(triangles.has_value());
  double area = 0;
  std::vector<std::array<Index, 2>> there, back;
  for (const auto& t : *triangles) {
    const double one = loop_area(drawing.points, {t[0], t[1], t[2]});
    EXPECT_GE(one, 0);
    area += one;
    for (std::size_t i = 0; i < 3; ++i) there.push_back({t[i], t[(i + 1) % 3]});
  }
  EXPECT_NEAR(area, drawing.area(), 1e-14 * drawing.area());
  for (const auto& [from, to] : there) back.push_back({to, from});
  for (const CornerLoop& loop : drawing.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) back.push_back({loop[i], loop[(i + 1) % loop.size()]});
  for (const CornerLoop& loop : drawing.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) there.push_back({loop[(i + 1) % loop.size()], loop[i]});
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  EXPECT_EQ(there, back);
}

TEST(CutLoops, APolygonAlone) {
  Drawing drawing;
  drawing.add_ring({}, 1, 9);
  expect_cut(drawing);
}

TEST(CutLoops, HolesAndIslandsInThem) {
  Drawing drawing;
  drawing.add_ring({}, 10, 7);
  drawing.add_ring({-4, 0}, 2, -5);
  drawing.add_ring({4, 0}, 3, -8, 0.3);
  drawing.add_ring({4, 0}, 2, 6);
  drawing.add_ring({4, 0}, 1, -3);
  drawing.add_ring({0, 5}, 1, -4);
  drawing.add_ring({30, 0}, 1, 4);
  expect_cut(drawing);
}

TEST(CutLoops, HolesWhoseCornersLieAtOneHeight) {
  Drawing drawing;
  drawing.add_ring({}, 10, 4, std::numbers::pi / 4);
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) drawing.add_ring({2.5 * i, 2.5 * j}, 1, -4);
  expect_cut(drawing);
}

TEST(CutLoops, ManyRandomHoles) {
  Random random(11);
  for (int round = 0; round < 50; ++round) {
    Drawing drawing;
    drawing.add_ring({}, 20, 5 + round % 7, 0.1 * round);
    for (int i = -3; i <= 3; ++i)
      for (int j = -3; j <= 3; ++j) {
        const Vec2 middle{3 * i + random.between(-0.4, 0.4), 3 * j + random.between(-0.4, 0.4)};
        if (random.below(3) > 0)
          drawing.add_ring(middle, random.between(0.1, 1), -3 - static_cast<int>(random.below(9)), round);
      }
    expect_cut(drawing);
  }
}

TEST(CutLoops, EdgesThatMeetInAPointBecomeLoopsThatDoNotCross) {
  // Two squares that touch at the point 2.
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  const std::vector<std::array<Index, 2>> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 5}, {5, 6}, {6, 2}};
  const std::vector<CornerLoop> loops = loops_of_edges(points, edges);
  double area = 0;
  for (const CornerLoop& loop : loops) {
    EXPECT_GT(loop_area(points, loop), 0);
    area += loop_area(points, loop);
  }
  EXPECT_EQ(area, 2);
  const auto triangles = cut_loops(points, loops, 0);
  ASSERT_TRUE(triangles.has_value());
  EXPECT_EQ(triangles->size(), 4U);
}

TEST(CutLoops, WhatCrossesItselfByALittleIsCutButForThat) {
  // The corners 0 and 1 are in the wrong order by 1e-17.
  const std::vector<Vec2> points{{0, 0}, {-1e-17, 0}, {1, -1}, {1, 1}, {-1, 0.5}};
  const std::vector<CornerLoop> loops{{0, 1, 2, 3, 4}};
  EXPECT_TRUE(cut_loops(points, loops, 1e-15).has_value());
  // A bow tie crosses itself by much.
  const std::vector<Vec2> bow{{0, 0}, {2, 2}, {2, 0}, {0, 1}};
  EXPECT_FALSE(cut_loops(bow, std::vector<CornerLoop>{{0, 1, 2, 3}}, 1e-15).has_value());
}

}  // namespace
}  // namespace toccata
