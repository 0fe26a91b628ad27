#include "toccata/narrow/casts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "narrow/casts_checks.hpp"
#include "oracle/convex.hpp"
#include "support/convex_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

TEST(Cast, AgreesWithTheOracleForEveryKindAndRegime) {
  std::uint64_t number = 0;
  int hits = 0;
  for (const std::string& kind_a : test::convex_kinds())
    for (const std::string& kind_b : test::convex_kinds())
      for (const std::string regime : {"far", "near", "ulp", "parallel", "ratio", "small", "large", "distant"}) {
        Random random(++number);
        if (number % 4 != 0) continue;
        const test::ConvexCase pair = test::convex_case(kind_a, kind_b, regime, random);
        const Vec3 motion = test::random_motion(pair, random);
        const std::optional<Cast> cast = cast_shape(test::posed(pair.a), motion, test::posed(pair.b));
        hits += cast.has_value() ? 1 : 0;
        ASSERT_EQ(test::cast_fault(cast, test::set_of(pair.a), motion, test::set_of(pair.b)), "")
            << kind_a << " and " << kind_b << ", " << regime << ", seed " << number << ": " << to_text(pair);
      }
  EXPECT_GT(hits, 100);
}

TEST(Cast, AtAShapeMuchLargerThanItsWayTakesNoExactArithmetic) {
  Random random(17);
  const auto within = [&](double size) { return random.between(-size, size); };
  for (const double size : {1e2, 1e3, 1e4})
    for (int i = 0; i < 30; ++i) {
      const double axis_x = within(1), axis_y = within(1);
      const Pose pose{rotation_about({axis_x, axis_y, 1}, random.between(0, 180)), {}};
      const Vec3 up = pose.linear.column(2);
      const double along_x = within(0.3 * size), along_y = within(0.3 * size);
      const Vec3 from = (size + 6) * up + along_x * pose.linear.column(0) + along_y * pose.linear.column(1);
      const Vec3 motion = -10.0 * up + Vec3{within(2), within(2), within(2)};
      const test::PlacedPolytope large{Box({size, size, size}), pose};
      const std::vector<test::PlacedPolytope> moving{
          {Point(from), {}},
          {Sphere(0.5, from), {}},
          {Box({0.5, 0.4, 0.3}), {rotation_about({1, 2, 3}, within(90)), from}}};
      for (const test::PlacedPolytope& a : moving) {
        SimplexCache workspace;
        const std::optional<Cast> cast = cast_shape(test::posed(a), motion, test::posed(large), &workspace);
        ASSERT_TRUE(cast);
        EXPECT_EQ(workspace.counts.exact, 0U) << size << ", case " << i;
        ASSERT_EQ(test::cast_fault(cast, test::set_of(a), motion, test::set_of(large)), "") << size << ", case " << i;
      }
    }
}

TEST(Cast, AgainstAHalfSpaceAgreesWithTheOracle) {
  std::uint64_t number = 0;
  for (const std::string& kind : test::convex_kinds())
    for (const std::string& regime : test::convex_regimes()) {
      Random random(++number);
      const test::HalfSpaceCase pair = test::half_space_case(kind, regime, random);
      const PosedPolytope a = test::posed(pair.a);
      const PosedHalfSpace b = test::posed(pair.b);
      const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
      const Vec3 motion = 3.0 * Vec3{x, y, z} - random.between(0, 1) * (a.vertex(0) - b.point);
      const std::optional<Cast> cast = cast_shape(a, motion, b);
      const oracle::ConvexSet set = test::set_of(pair.a);
      const oracle::HalfSpace half_space = test::set_of(pair.b);
      const auto meets = [&](double until) { return oracle::overlap(test::swept(set, motion, until), half_space); };
      ASSERT_EQ(cast.has_value(), meets(1)) << kind << ", " << regime << ", seed " << number;
      if (!cast.has_value() || cast->upper == 0) continue;
      ASSERT_TRUE(meets(cast->upper));
      ASSERT_TRUE(cast->lower == cast->upper || !meets(cast->lower));
      ASSERT_TRUE(cast->upper <= std::nextafter(cast->lower, 2));
    }
}

TEST(Cast, RaysAtTheRimOfATriangle) {
  // The museum: rays through vertices, along edges, and a last place beside them.
  const Triangle triangle{{Vec3{0, 0, 0}, Vec3{3, 0, 0}, Vec3{0, 3, 0}}};
  const PosedPolytope target(triangle);
  const Vec3 down{0, 0, -2};
  EXPECT_TRUE(cast_ray({0, 0, 1}, down, target));
  EXPECT_TRUE(cast_ray({1, 2, 1}, down, target));
  EXPECT_FALSE(cast_ray({1, std::nextafter(2, 3), 1}, down, target));
  EXPECT_FALSE(cast_ray({-5e-324, 1, 1}, down, target));
  EXPECT_TRUE(cast_ray({5e-324, 1, 1}, down, target));
  const std::optional<Cast> along = cast_ray({-1, 0, 0}, {2, 0, 0}, target);  // in the plane, onto an edge's line
  ASSERT_TRUE(along);
  EXPECT_NEAR(along->lower, 0.5, 1e-12);
  EXPECT_FALSE(cast_ray({-1, 0, 5e-324}, {2, 0, 0}, target));
  const std::optional<Cast> straight = cast_ray({1, 1, 1}, down, target);
  EXPECT_NEAR(straight->upper, 0.5, 1e-12);
  EXPECT_NEAR(straight->normal.z, 1, 1e-12);
  EXPECT_NEAR(straight->point.x, 1, 1e-12);
}

TEST(Cast, NoRaySlipsThroughASharedEdge) {
  // Two triangles that share an edge make a wall: each ray through the wall meets at least one of them.
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto point = [&](double z) {
      const double x = random.between(-1, 1), y = random.between(-1, 1);
      return Vec3{x, y, z * random.between(0.5, 1)};
    };
    const Vec3 p = 0.1 * point(1), q = 0.1 * point(-1);
    const Triangle left{{p, q, Vec3{-30, -30, 0}}}, right{{q, p, Vec3{30, 30, 0}}};
    const Vec3 on_edge = p + random.unit() * (q - p);
    const Vec3 from{on_edge.x + 5, on_edge.y - 5, on_edge.z};
    const Vec3 motion = 2.0 * (on_edge - from);
    EXPECT_TRUE(cast_ray(from, motion, PosedPolytope(left)) || cast_ray(from, motion, PosedPolytope(right)));
  }
}

TEST(Cast, EndsCount) {
  const PosedPolytope box(Box({1, 1, 1}));
  EXPECT_TRUE(cast_ray({3, 0, 0}, {-2, 0, 0}, box));  // arrives at the last moment
  EXPECT_EQ(cast_ray({3, 0, 0}, {-2, 0, 0}, box)->upper, 1);
  EXPECT_FALSE(cast_ray({3, 0, 0}, {std::nextafter(-2, 0), 0, 0}, box));
  EXPECT_EQ(cast_ray({1, 0, 0}, {5, 0, 0}, box)->upper, 0);  // touches at the start
  EXPECT_FALSE(cast_ray({std::nextafter(1, 2), 0, 0}, {5, 0, 0}, box));
  EXPECT_EQ(cast_ray({0, 0, 0}, {5, 0, 0}, box)->upper, 0);  // starts inside
}

TEST(Cast, WhatDoesNotMoveMeetsWhatItTouches) {
  // Rotated so that no formula and no axis of the world decides.
  const Pose turned{rotation_about({1, 2, 3}, 40), {0.1, 0.2, 0.3}};
  const ConvexHull hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const PosedPolytope prism(hull, turned);
  const Vec3 corner = prism.vertex(0);
  EXPECT_TRUE(cast_shape(PosedPolytope(Segment(corner, corner + Vec3{-1, -2, -3})), {}, prism));
  const Vec3 beside{std::nextafter(corner.x, -10), corner.y, corner.z};
  EXPECT_EQ(cast_shape(PosedPolytope(Segment(beside, beside + Vec3{-1, 0, 0})), {}, prism).has_value(),
            overlap(PosedPolytope(Segment(beside, beside + Vec3{-1, 0, 0})), prism));
  EXPECT_FALSE(cast_shape(PosedPolytope(Sphere(1, {9, 0, 0})), {}, PosedPolytope(Sphere(2))));
}

TEST(Cast, SpheresThatPassAtTheSumOfTheirRadiiTouch) {
  const PosedPolytope moving(Sphere(1, {-10, 3, 0})), standing(Sphere(2));
  const std::optional<Cast> grazing = cast_shape(moving, {20, 0, 0}, standing);
  ASSERT_TRUE(grazing);
  EXPECT_LE(grazing->lower, 0.5);
  EXPECT_GE(grazing->upper, 0.5);
  EXPECT_LE(grazing->upper - grazing->lower, 1e-12);
  EXPECT_FALSE(cast_shape(PosedPolytope(Sphere(1, {-10, std::nextafter(3, 4), 0})), {20, 0, 0}, standing));
  const std::optional<Cast> square = cast_shape(PosedPolytope(Sphere(1, {-10, 0, 0})), {20, 0, 0}, standing);
  EXPECT_NEAR(square->lower, 7.0 / 20, 1e-12);
  EXPECT_NEAR(square->normal.x, -1, 1e-12);
  EXPECT_NEAR(square->point.x, -2, 1e-9);
}

TEST(Cast, OfShapesThatPassEachOtherIsTheSameWithAWorkspace) {
  const PosedPolytope standing(Box({1, 0.5, 0.25}));
  SimplexCache workspace;
  int hits = 0;
  for (int step = 0; step < 300; ++step) {
    const double angle = 0.02 * step;
    const Vec3 way{std::cos(angle), std::sin(angle), 0};
    const PosedPolytope moving(Box({0.2, 0.3, 0.4}), {rotation_about({1, 2, 3}, step), 3 * way});
    const Vec3 motion = step % 100 < 50 ? Vec3{-2 * way.y, 2 * way.x, 0.5} : -2.5 * way;
    const std::optional<Cast> cast = cast_shape(moving, motion, standing);
    EXPECT_EQ(cast_shape(moving, motion, standing, &workspace), cast) << step;
    hits += cast.has_value() ? 1 : 0;
  }
  EXPECT_GT(hits, 50);
  EXPECT_LT(hits, 250);
}

TEST(Cast, BadInputIsRefused) {
  const PosedPolytope box(Box({1, 1, 1}));
  EXPECT_THROW(static_cast<void>(cast_ray({0, 0, 0}, {0, 0, 0}, box)), Error);
  EXPECT_THROW(static_cast<void>(cast_ray({NAN, 0, 0}, {1, 0, 0}, box)), Error);
  EXPECT_THROW(static_cast<void>(cast_shape(box, {HUGE_VAL, 0, 0}, box)), Error);
  EXPECT_FALSE(cast_shape(PosedPolytope(Sphere(1, {9, 0, 0})), {}, box));
}

}  // namespace
}  // namespace toccata
