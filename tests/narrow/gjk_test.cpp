#include <gtest/gtest.h>

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
  ConvexWorkspace workspace;
  for (int i = 0; i < 100; ++i) {
    const ConvexHull a = random_ball(32, random), b = random_ball(32, random);
    workspace.simplex_size = 0;
    static_cast<void>(distance(PosedConvex(a), PosedConvex(b, turned_at(i, {2.1, 0.3, 0.2})), &workspace));
  }
  EXPECT_LT(workspace.counts.support_points, 100U * 20);
  EXPECT_EQ(workspace.counts.exact, 0U);
}

TEST(Gjk, AWarmStartSavesMostSupports) {
  Random random(1);
  const ConvexHull a = random_ball(64, random), b = random_ball(64, random);
  ConvexWorkspace kept, forgotten;
  for (int step = 0; step < 1000; ++step) {
    const PosedConvex posed_a(a), posed_b(b, turned_at(0.01 * step, {2.1, 0.3, 0.2}));
    static_cast<void>(distance(posed_a, posed_b, &kept));
    forgotten.simplex_size = 0;
    static_cast<void>(distance(posed_a, posed_b, &forgotten));
  }
  EXPECT_LT(5 * kept.counts.support_points, forgotten.counts.support_points);
}

}  // namespace
}  // namespace toccata
