#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/convex_cases.hpp"
#include "toccata/narrow/convex_convex.hpp"

// The questions of docs/methods/gjk.md.
namespace toccata {
namespace {

using test::ConvexCase;

ConvexHull random_ball(std::size_t vertices, Random& random) {
  std::vector<Vec3> points;
  while (points.size() < vertices) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    const double length = std::hypot(x, y, z);
    if (length > 0.1 && length < 1) points.push_back({x / length, y / length, z / length});
  }
  return ConvexHull(points);
}

Pose turned_at(double angle, const Vec3& offset) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{{Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}}}, offset};
}

TEST(Gjk, TheDifferenceContainsTheOriginWhenTheShapesMeet) {
  Random random(1);
  for (const char* regime : {"touching", "near", "deep"})
    for (int i = 0; i < 30; ++i) {
      const ConvexCase pair = test::convex_case("triangle", "hull", regime, random);
      const oracle::ConvexSet a = test::set_of(pair.a), b = test::set_of(pair.b);
      oracle::ConvexSet difference;
      for (const oracle::RationalPoint& p : a.vertices)
        for (const oracle::RationalPoint& q : b.vertices) difference.vertices.push_back(p - q);
      const bool contains_origin = oracle::overlap(difference, oracle::point_set({0, 0, 0}));
      EXPECT_EQ(overlap(test::posed(pair.a), test::posed(pair.b)), contains_origin) << to_text(pair);
    }
}

TEST(Gjk, LooksAtFewVerticesOfTheDifference) {
  Random random(1);
  SimplexCache workspace;
  for (int i = 0; i < 100; ++i) {
    const ConvexHull a = random_ball(32, random), b = random_ball(32, random);
    workspace.simplex_size = 0;
    static_cast<void>(distance(PosedPolytope(a), PosedPolytope(b, turned_at(i, {2.1, 0.3, 0.2})), &workspace));
  }
  EXPECT_LT(workspace.counts.support_points, 100U * 20);
  EXPECT_EQ(workspace.counts.exact, 0U);
}

TEST(Gjk, AWarmStartSavesMostSupports) {
  Random random(1);
  const ConvexHull a = random_ball(64, random), b = random_ball(64, random);
  SimplexCache kept, forgotten;
  for (int step = 0; step < 1000; ++step) {
    const PosedPolytope posed_a(a), posed_b(b, turned_at(0.01 * step, {2.1, 0.3, 0.2}));
    static_cast<void>(distance(posed_a, posed_b, &kept));
    forgotten.simplex_size = 0;
    static_cast<void>(distance(posed_a, posed_b, &forgotten));
  }
  EXPECT_LT(5 * kept.counts.support_points, forgotten.counts.support_points);
}

constexpr GjkOptions manners[] = {{GjkSupport::scan, GjkAcceleration::none},
                                  {GjkSupport::scan, GjkAcceleration::nesterov},
                                  {GjkSupport::hill_climbing, GjkAcceleration::none},
                                  {GjkSupport::hill_climbing, GjkAcceleration::nesterov}};

/// The counts of questions about two hulls that are turned and moved, all from the beginning.
ConvexCounts counts_of(std::size_t vertices, const GjkOptions& options) {
  Random random(2);
  SimplexCache workspace;
  for (int pair = 0; pair < 3; ++pair) {
    const ConvexHull a = random_ball(vertices, random), b = random_ball(vertices, random);
    for (int i = 0; i < 20; ++i) {
      workspace.simplex_size = 0;
      static_cast<void>(
          distance_by_gjk(PosedPolytope(a), PosedPolytope(b, turned_at(i, {2.02, 0.3, 0.2})), options, &workspace));
    }
  }
  return workspace.counts;
}

TEST(Gjk, ClimbingLooksAtFewVerticesOfLargeHulls) {
  const ConvexCounts scanned = counts_of(2000, manners[0]), climbed = counts_of(2000, manners[2]);
  EXPECT_LT(20 * climbed.heights, scanned.heights);
  EXPECT_EQ(climbed.steps, scanned.steps);  // by the same vertices
  EXPECT_EQ(counts_of(2000, {}), scanned);  // what is faster for so few
}

TEST(Gjk, MomentumTakesOtherSteps) { EXPECT_NE(counts_of(500, manners[0]).steps, counts_of(500, manners[1]).steps); }

/// What is flat, needle-like, made of one point, tiny or huge: every manner ends, with the same bits.
TEST(Gjk, EveryMannerEndsOnDegenerateHulls) {
  Random random(4);
  for (const double size : {1e-308, 1e-300, 1e-100, 1.0, 1e150, 1e300})
    for (const Vec3& shape : {Vec3{1, 1, 1}, Vec3{1, 1, 0}, Vec3{1, 1e-12, 1e-12}, Vec3{1, 0, 0}, Vec3{0, 0, 0}}) {
      std::vector<Vec3> points;
      for (int i = 0; i < 600; ++i) {
        const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
        const double length = std::hypot(x, y, z);
        points.push_back(size * Vec3{shape.x * (x / length), shape.y * (y / length), shape.z * (z / length)});
      }
      const ConvexHull a(points), b(std::vector<Vec3>(points.begin() + 100, points.begin() + 400));
      for (const Vec3& offset : {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{2.5, 1, 0.5}}) {
        const PosedPolytope posed_a(a), posed_b(b, turned_at(0.3, size * offset));
        const Distance first = distance_by_gjk(posed_a, posed_b, manners[0]);
        const Distance chosen = distance(posed_a, posed_b);
        EXPECT_LE(std::max(first.lower, chosen.lower), std::min(first.upper, chosen.upper));
        for (const GjkOptions& manner : manners) {
          SimplexCache workspace;
          for (int i = 0; i < 2; ++i) EXPECT_EQ(distance_by_gjk(posed_a, posed_b, manner, &workspace), first);
          EXPECT_EQ(overlap_by_gjk(posed_a, posed_b, manner, &workspace), first.upper == 0);
        }
      }
    }
}

}  // namespace
}  // namespace toccata
