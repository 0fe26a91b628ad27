// How deep quadrics lie in others: depths that are known, and how narrow the intervals are.
#include <gtest/gtest.h>

#include <cmath>

#include "toccata/math/pose.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata::test {
namespace {

template <class B>
void expect_depth(const PosedQuadric& a, const B& b, double depth, const Vec3& direction) {
  const Penetration found = penetration(a, b);
  EXPECT_EQ(found.status, Status::exact);
  EXPECT_LE(found.lower, depth * (1 + 1e-15));
  EXPECT_GE(found.upper, depth * (1 - 1e-15));
  EXPECT_LE(found.upper, found.lower * (1 + 1e-12));
  EXPECT_GT(dot(found.direction, direction), 1 - 1e-9);
  const Penetration back = penetration(b, a);
  EXPECT_EQ(back.upper, found.upper);
  EXPECT_EQ(back.lower, found.lower);
  EXPECT_EQ(back.direction, -found.direction);
  EXPECT_EQ(back.on_a, found.on_b);
}

TEST(QuadricPenetration, OfEllipsoidsAlongAnAxisIsTheSumOfHalfAxesLessTheWay) {
  const PosedQuadric egg(Ellipsoid({1, 2, 3}));
  expect_depth(egg, PosedQuadric(Ellipsoid({0.5, 0.5, 0.5}), Pose::translation(0, 0, 3.25)), 0.25, {0, 0, 1});
  expect_depth(egg, PosedQuadric(Ellipsoid({4, 0.5, 4}), Pose::translation(0, -2.375, 0)), 0.125, {0, -1, 0});
}

TEST(QuadricPenetration, OfCansConesAndBoxesIsThatOfTheirFaces) {
  const PosedPolytope table(Box({2, 2, 0.5}), Pose::translation(0, 0, -0.5));
  expect_depth(PosedQuadric(Cone(1, 1), Pose::translation(0, 0, 0.75)), table, 0.25, {0, 0, -1});
  expect_depth(PosedQuadric(Cylinder(0.5, 1), Pose::translation(0.25, 0, 0.875)), table, 0.125, {0, 0, -1});
  // Lying on its side, and standing beside another one.
  const Mat3 lying = {{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}};
  expect_depth(PosedQuadric(Cylinder(0.5, 1), {lying, {0, 0, 0.375}}), table, 0.125, {0, 0, -1});
  const PosedQuadric can(Cylinder(0.5, 1));
  expect_depth(can, PosedQuadric(Cylinder(0.5, 2), Pose::translation(0.875, 0, 0)), 0.125, {1, 0, 0});
}

// Half axes that differ by a million.
TEST(QuadricPenetration, OfParallelBarsThatAreTurnedOverIsAcrossThem) {
  for (const double turn_a : {1.0, -1.0})
    for (const double turn_b : {1.0, -1.0}) {
      const Pose over_a{{{Vec3{-1, 0, 0}, Vec3{0, -turn_a, 0}, Vec3{0, 0, turn_a}}}, {}};
      const Pose over_b{{{Vec3{-1, 0, 0}, Vec3{0, -turn_b, 0}, Vec3{0, 0, turn_b}}}, {-2, 0, 0}};
      const Penetration p = penetration(PosedQuadric(Cylinder(2, 2), over_a), PosedQuadric(Cylinder(1, 3), over_b));
      EXPECT_NEAR(p.upper, 1, 1e-12);
      EXPECT_GE(p.lower, p.upper * (1 - 1e-12));
    }
}

TEST(QuadricPenetration, OfCoinsAndNeedlesIsAsNarrow) {
  const double slim = 0x1p-20;
  const PosedPolytope crate(Box({2, 2, 2}));
  expect_depth(PosedQuadric(Cylinder(1, slim), Pose::translation(0, 0, 1.5)), crate, 0.5 + slim, {0, 0, -1});
  expect_depth(PosedQuadric(Ellipsoid({slim, slim, 1}), Pose::translation(1.5, 0.25, 0)), crate, 0.5 + slim,
               {-1, 0, 0});
  const PosedQuadric needle(Ellipsoid({slim, slim, 1}));
  expect_depth(needle, PosedQuadric(Ellipsoid({slim, 1, slim}), Pose::translation(slim, 0, 0)), slim, {1, 0, 0});
  const PosedQuadric coin(Ellipsoid({1, 1, slim}));
  expect_depth(coin, PosedQuadric(Ellipsoid({1, 1, slim}), Pose::translation(0, 0, 1.5 * slim)), 0.5 * slim, {0, 0, 1});
}

// Around one centre and along one axis all directions across are as low: the interval is a part of the depth wide.
TEST(QuadricPenetration, OfWhatIsAsDeepInManyDirectionsIsAPartWide) {
  const auto expect_bracket = [](const PosedQuadric& a, const PosedQuadric& b, double depth) {
    const Penetration found = penetration(a, b);
    EXPECT_LE(found.lower, depth * (1 + 1e-15));
    EXPECT_GE(found.upper, depth * (1 - 1e-15));
    EXPECT_GE(found.lower, 0.9 * depth);
  };
  expect_bracket(PosedQuadric(Ellipsoid({1, 1, 1})), PosedQuadric(Ellipsoid({2, 2, 2})), 3);
  expect_bracket(PosedQuadric(Cylinder(0.5, 8)), PosedQuadric(Cylinder(0.25, 16)), 0.75);
  expect_bracket(PosedQuadric(Ellipsoid({1, 1, 1024})), PosedQuadric(Cylinder(1, 1024)), 2);
}

/// An egg leans into a can, whose rim it meets.
Penetration leaning(double scale, bool mirrored) {
  const double side = mirrored ? -1 : 1;
  Mat3 turned = rotation_about({0.6, 0, 0.8}, 40);
  if (mirrored)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if ((i == 1) != (j == 1)) turned[i][j] = -turned[i][j];
  const PosedQuadric can(Cylinder(0.5 * scale, 1 * scale));
  return penetration(can, PosedQuadric(Ellipsoid({0.5 * scale, 0.75 * scale, 1 * scale}),
                                       {turned, {0.75 * scale, side * 0.25 * scale, 1.25 * scale}}));
}

TEST(QuadricPenetration, GrowsWithThePairAndTurnsWithItsMirrorImage) {
  const Penetration found = leaning(1, false), mirrored = leaning(1, true);
  EXPECT_EQ(found.status, Status::exact);
  EXPECT_NEAR(mirrored.upper, found.upper, 1e-12 * found.upper);
  EXPECT_NEAR(mirrored.direction.y, -found.direction.y, 1e-6);
  for (const double scale : {0x1p-300, 0x1p+300}) {
    const Penetration other = leaning(scale, false);
    EXPECT_EQ(other.lower, scale * found.lower);
    EXPECT_EQ(other.upper, scale * found.upper);
    EXPECT_EQ(other.direction, found.direction);
  }
}

}  // namespace
}  // namespace toccata::test
