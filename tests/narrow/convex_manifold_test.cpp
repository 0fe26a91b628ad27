#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "narrow/penetration_checks.hpp"
#include "support/convex_cases.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

Pose pose_at(double x, double y, double z) { return Pose::translation(x, y, z); }

std::vector<Vec3> positions(const Manifold& m) {
  std::vector<Vec3> result;
  for (int i = 0; i < m.count; ++i) result.push_back(m.points[static_cast<std::size_t>(i)].position);
  std::sort(result.begin(), result.end(), lexicographically_less);
  return result;
}

TEST(ConvexManifold, OfACubeOnACubeAreTheFourCornersOfTheirCommonFace) {
  const PosedPolytope floor(Box({2, 2, 1})), cube(Box({0.5, 0.5, 0.5}), pose_at(0.25, 0, 1.5));
  const Manifold m = manifold(floor, cube);
  EXPECT_EQ(m.normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(positions(m), (std::vector<Vec3>{{-0.25, -0.5, 1}, {-0.25, 0.5, 1}, {0.75, -0.5, 1}, {0.75, 0.5, 1}}));
  for (const ManifoldPoint& p : m.points) {
    EXPECT_EQ(p.depth, 0);
    EXPECT_EQ(p.on_a, (ConvexFeature{ConvexFeature::Kind::face, 5}));
    EXPECT_EQ(p.on_b.kind, ConvexFeature::Kind::vertex);
  }
}

TEST(ConvexManifold, IsEmptyExactlyWhenTheShapesAreApart) {
  const PosedPolytope cube(Box({1, 1, 1}));
  EXPECT_EQ(manifold(cube, PosedPolytope(Box({1, 1, 1}), pose_at(2, 0, 0))).count, 4);
  EXPECT_EQ(manifold(cube, PosedPolytope(Box({1, 1, 1}), pose_at(std::nextafter(2, 3), 0, 0))).count, 0);
}

TEST(ConvexManifold, OfCrossedBarsHasThePointsWhereEdgesCross) {
  const PosedPolytope below(Box({2, 0.5, 0.5})), above(Box({0.5, 2, 0.5}), pose_at(0, 0, 0.75));
  const Manifold m = manifold(below, above);
  EXPECT_EQ(m.normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(positions(m),
            (std::vector<Vec3>{{-0.5, -0.5, 0.375}, {-0.5, 0.5, 0.375}, {0.5, -0.5, 0.375}, {0.5, 0.5, 0.375}}));
  for (const ManifoldPoint& p : m.points) {
    EXPECT_EQ(p.depth, 0.25);
    EXPECT_EQ(p.on_a.kind, ConvexFeature::Kind::edge);
    EXPECT_EQ(p.on_b.kind, ConvexFeature::Kind::edge);
  }
}

TEST(ConvexManifold, OfAVertexOnAFaceIsOnePoint) {
  const PosedPolytope floor(Box({2, 2, 1}));
  const Mat3 tip = rotation_about({1, -1, 0}, 54.735610317245346);
  const PosedPolytope cube(Box({0.5, 0.5, 0.5}), {tip, {0, 0, 1 + 0.5 * std::numbers::sqrt3 - 0.01}});
  const Manifold m = manifold(floor, cube);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.points[0].depth, 0.01, 1e-12);
  EXPECT_EQ(m.points[0].on_a, (ConvexFeature{ConvexFeature::Kind::face, 5}));
  EXPECT_EQ(m.points[0].on_b.kind, ConvexFeature::Kind::vertex);
}

TEST(ConvexManifold, OfTwoEdgesIsOnePoint) {
  const PosedPolytope below(Box({2, 0.5, 0.5}), {rotation_about({1, 0, 0}, 45), {}});
  const double height = std::numbers::sqrt2 - 0.01;
  const PosedPolytope above(Box({0.5, 2, 0.5}), {rotation_about({0, 1, 0}, 45), {0, 0, height}});
  const Manifold m = manifold(below, above);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.points[0].depth, 0.01, 1e-12);
  EXPECT_NEAR(m.normal.z, 1, 1e-12);
  EXPECT_EQ(m.points[0].on_a.kind, ConvexFeature::Kind::edge);
  EXPECT_EQ(m.points[0].on_b.kind, ConvexFeature::Kind::edge);
}

TEST(ConvexManifold, OfSpheresIsOnePointHalfWay) {
  const PosedPolytope a{Sphere(1)}, b(Sphere(1), pose_at(1.5, 0, 0));
  const Manifold m = manifold(a, b);
  ASSERT_EQ(m.count, 1);
  EXPECT_EQ(m.normal, (Vec3{1, 0, 0}));
  EXPECT_EQ(m.points[0].position, (Vec3{0.75, 0, 0}));
  EXPECT_EQ(m.points[0].depth, 0.5);
}

TEST(ConvexManifold, OfALyingCapsuleAreItsTwoEnds) {
  const PosedPolytope floor(Box({4, 4, 1})), capsule(Capsule({-1, 0, 0}, {1, 0, 0}, 0.5), pose_at(0, 0, 1.5));
  const Manifold m = manifold(floor, capsule);
  EXPECT_EQ(m.normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(positions(m), (std::vector<Vec3>{{-1, 0, 1}, {1, 0, 1}}));
}

TEST(ConvexManifold, OfParallelCapsulesAreTheEndsOfTheirCommonPart) {
  const Capsule capsule({-1, 0, 0}, {1, 0, 0}, 0.5);
  const Manifold m = manifold(PosedPolytope(capsule), PosedPolytope(capsule, pose_at(0.5, 0, 0.75)));
  EXPECT_EQ(m.normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(positions(m), (std::vector<Vec3>{{-0.5, 0, 0.375}, {1, 0, 0.375}}));
  for (int i = 0; i < m.count; ++i) EXPECT_EQ(m.points[static_cast<std::size_t>(i)].depth, 0.25);
}

TEST(ConvexManifold, OfFlatShapesIsDefined) {
  const PosedPolytope floor(Triangle{{{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}}}});
  const PosedPolytope lying(Triangle{{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}});
  const Manifold flat = manifold(floor, lying);
  EXPECT_EQ(flat.count, 3);
  EXPECT_EQ(std::fabs(flat.normal.z), 1);
  const PosedPolytope fin(Triangle{{{{-1, 0, -0.125}, {1, 0, -0.125}, {0, 0, 2}}}});
  const Manifold crossing = manifold(floor, fin);
  EXPECT_EQ(crossing.count, 2);
  EXPECT_EQ(crossing.normal, (Vec3{0, 0, 1}));
  const PosedPolytope needle(Segment({0, 0, -1}, {0, 0, 0.25}));
  EXPECT_EQ(manifold(floor, needle).count, 1);
  EXPECT_EQ(manifold(needle, PosedPolytope(Segment({-1, 0, 0}, {1, 0, 0}))).count, 1);
  EXPECT_EQ(manifold(PosedPolytope(Point{}), PosedPolytope(Point{})).count, 1);
}

TEST(ConvexManifold, OfManyCornersKeepsFourThatSpanTheContact) {
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) {
    const double angle = i * std::numbers::pi / 6;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    points.push_back({std::cos(angle), std::sin(angle), 1});
  }
  const ConvexHull coin(points);
  const Manifold m = manifold(PosedPolytope(Box({4, 4, 1})), PosedPolytope(coin, pose_at(0, 0, 1)));
  ASSERT_EQ(m.count, 4);
  const std::vector<Vec3> at_points = positions(m);
  // The two points farthest apart are a diameter, and the others lie on both sides of it.
  EXPECT_NEAR(at_points[3].x - at_points[0].x, 2, 0.3);
}

TEST(ConvexManifold, KeepsItsFeaturesWhileTheContactLasts) {
  const PosedPolytope floor(Box({2, 2, 1}));
  const Manifold first = manifold(floor, PosedPolytope(Box({0.5, 0.5, 0.5}), pose_at(0.25, 0, 1.49)));
  const Manifold next = manifold(floor, PosedPolytope(Box({0.5, 0.5, 0.5}), pose_at(0.2501, 0.0001, 1.4899)));
  ASSERT_EQ(first.count, 4);
  ASSERT_EQ(next.count, 4);
  for (const ManifoldPoint& p : first.points)
    EXPECT_EQ(std::count_if(next.points.begin(), next.points.end(),
                            [&](const ManifoldPoint& q) { return p.on_a == q.on_a && p.on_b == q.on_b; }),
              1);
}

TEST(ConvexManifold, OfHullsIsAsDeepAsTheirPenetration) {
  Random random(5);
  int deep = 0;
  for (const char* regime : {"deep", "hair", "close", "ulp"})
    for (int i = 0; i < 50; ++i) {
      const test::ConvexCase pair = test::convex_case("hull", "hull", regime, random);
      const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
      if (!a.solid() || !b.solid()) continue;
      const Penetration p = penetration(a, b);
      const Manifold m = manifold(a, b);
      double greatest = 0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(m.count); ++k)
        greatest = std::max(greatest, m.points[k].depth);
      const double rounding = 0x1p-48 * test::size_of(test::set_of(pair.a));
      EXPECT_LE(greatest, (1 + 0x1p-20) * p.upper + rounding) << regime << ' ' << i;
      EXPECT_GE(greatest, (1 - 0x1p-19) * p.lower - rounding) << regime << ' ' << i;
      deep += p.upper > 0 ? 1 : 0;
    }
  EXPECT_GE(deep, 60);
}

/// Each point is on both shapes, grown by half its depth.
void expect_between(const Manifold& m, const PosedPolytope& a, const PosedPolytope& b) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    const PosedPolytope point(Point(m.points[i].position));
    const double half = 0.5 * std::fabs(m.points[i].depth) + 1e-12;
    EXPECT_LE(distance(point, a).lower, half) << i;
    EXPECT_LE(distance(point, b).lower, half) << i;
  }
}

TEST(ConvexManifold, OfASegmentAcrossACapsuleByADegreeAreTheMiddleAndTheEndsOfTheSegment) {
  const Vec3 end{0.64950731779814663, -0.74895703673831882, -0.21276719315171716},
      of_core{0.6696900034690747, -0.74391778960636834, -0.20645803355780343};
  const PosedPolytope segment(Segment(end, -end)), capsule(Capsule(of_core, -of_core, 0.39260044598841681));
  const Manifold m = manifold(segment, capsule);
  ASSERT_EQ(m.count, 3);
  expect_between(m, segment, capsule);
  EXPECT_NEAR(m.points[0].depth, 0.3926, 1e-4);
  for (const ManifoldPoint& point : std::span(m.points).subspan(1, 2)) {
    EXPECT_EQ(point.on_a.kind, ConvexFeature::Kind::vertex);
    // The core passes the end of the segment at 0.0201 to the side.
    EXPECT_NEAR(point.depth, std::sqrt(0.3926 * 0.3926 - 0.0201 * 0.0201), 1e-4);
  }
}

TEST(ConvexManifold, OfANeedleLieBetweenTheTwo) {
  const double y = 1.0000009536743164, above = 1.0000009536743166, x = 1.0000000000000004;
  const ConvexHull bar(std::vector<Vec3>{{1.0000019073486328, y, -3},
                                         {1, 1, 0},
                                         {1, 1.0000019073486328, -3},
                                         {1.0000019073486328, 1.0000028610229492, -3},
                                         {1.0000019073486328, 1.0000028610229492, 0}}),
      needle(std::vector<Vec3>{{-1, y, -2.25},
                               {x, above, -0.24999999999999956},
                               {-1.1102230246251565e-16, y, -1.25},
                               {x, y, -1.25},
                               {-1, above, -1.25},
                               {x, y, -2.25},
                               {0, above, -2.25}});
  const PosedPolytope a(bar), b(needle);
  expect_between(manifold(a, b), a, b);
  expect_between(manifold(b, a), b, a);
}

TEST(ConvexManifold, ATinyBallOnABoxHasOnePoint) {
  const PosedPolytope box(Box({0.1, 0.1, 0.1}));
  for (int degrees = 0; degrees < 90; degrees += 7) {
    const Mat3 turn = rotation_about(Vec3{1, 2, 3}, degrees);
    const Vec3 beside = transform({turn, {}}, {0.03, 0.02, 0.1 + 4e-13});
    const PosedPolytope turned(Box({0.1, 0.1, 0.1}), {turn, {}}), ball(Sphere(5e-13, beside));
    EXPECT_EQ(manifold(turned, ball).count, 1) << degrees;
    EXPECT_EQ(manifold(ball, turned).count, 1) << degrees;
  }
}

}  // namespace
}  // namespace toccata
