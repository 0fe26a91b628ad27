#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "narrow/quadric_cases.hpp"
#include "narrow/quadric_manifold_checks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

namespace toccata::test {
namespace {

Pose placed_at(double x, double y, double z) { return Pose::translation(x, y, z); }

/// Its top is the plane z = 0.
PosedPolytope table() { return PosedPolytope(Box({2, 2, 0.5}), placed_at(0, 0, -0.5)); }

std::vector<Vec3> sorted_positions(const Manifold& m) {
  std::vector<Vec3> result;
  for (int i = 0; i < m.count; ++i) result.push_back(position_of(m, i));
  std::sort(result.begin(), result.end(), lexicographically_less);
  return result;
}

void expect_points(const Manifold& m, std::vector<Vec3> wanted, double depth) {
  std::sort(wanted.begin(), wanted.end(), lexicographically_less);
  const std::vector<Vec3> found = sorted_positions(m);
  ASSERT_EQ(found.size(), wanted.size());
  for (const Vec3& p : wanted)
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Vec3& q) { return dot(p - q, p - q) < 1e-22; }))
        << p.x << " " << p.y << " " << p.z;
  for (int i = 0; i < m.count; ++i) EXPECT_NEAR(m.points[static_cast<std::size_t>(i)].depth, depth, 1e-13);
}

const double part = std::sqrt(0.125);

TEST(QuadricManifold, OfAStandingCylinderAreFourPointsOfItsRim) {
  for (const double depth : {0.0, 0.01}) {
    const Manifold m = manifold(PosedQuadric(Cylinder(0.5, 1), placed_at(0, 0, 1 - depth)), table());
    EXPECT_EQ(m.normal, (Vec3{0, 0, -1}));
    const double z = -depth / 2;
    expect_points(m, {{part, part, z}, {-part, part, z}, {part, -part, z}, {-part, -part, z}}, depth);
    std::vector<Index> quarters;
    for (const ManifoldPoint& p : m.points) {
      EXPECT_EQ(p.on_a.kind, ConvexFeature::Kind::edge);
      EXPECT_EQ(p.on_b, (ConvexFeature{ConvexFeature::Kind::face, 5}));
      quarters.push_back(p.on_a.index);
    }
    std::sort(quarters.begin(), quarters.end());
    EXPECT_EQ(quarters, (std::vector<Index>{0, 1, 2, 3}));
  }
}

TEST(QuadricManifold, OfAStandingConeIsThatOfItsBase) {
  const Manifold m = manifold(PosedQuadric(Cone(0.5, 1), placed_at(0, 0, 1)), table());
  expect_points(m, {{part, part, 0}, {-part, part, 0}, {part, -part, 0}, {-part, -part, 0}}, 0);
  const Manifold tip = manifold(table(), PosedQuadric(Cone(0.5, 1), {rotation_about({1, 0, 0}, 180), {0, 0, 0.99}}));
  expect_points(tip, {{0, 0, -0.005}}, 0.01);
  EXPECT_EQ(tip.points[0].on_b, (ConvexFeature{ConvexFeature::Kind::vertex, 0}));
}

TEST(QuadricManifold, OverTheTablesEdgeAreTheEndsOfWhatStandsOnIt) {
  const PosedQuadric half_over(Cylinder(0.5, 1), placed_at(2, 0, 1));
  const Manifold m = manifold(half_over, table());
  ASSERT_EQ(m.count, 4);
  const std::vector<Vec3> at = sorted_positions(m);
  EXPECT_NEAR(at[0].x, 1.5, 1e-14);
  EXPECT_NEAR(at[2].x, 2, 1e-14);
  EXPECT_NEAR(at[2].y, -0.5, 1e-14);
  EXPECT_NEAR(at[3].y, 0.5, 1e-14);
  EXPECT_GT(hull_area(m), 0.6 * 3.14159 / 8);
}

TEST(QuadricManifold, OfALyingCylinderAreTheEndsOfItsLine) {
  const Mat3 lying = rotation_about({1, 0, 0}, 90);
  expect_points(manifold(PosedQuadric(Cylinder(0.5, 1), {lying, {0, 0, 0.5}}), table()), {{0, -1, 0}, {0, 1, 0}}, 0);
  const Manifold over = manifold(PosedQuadric(Cylinder(0.5, 1), {lying, {0, 1.5, 0.5 - 0.0625}}), table());
  expect_points(over, {{0, 0.5, -0.03125}, {0, 2, -0.03125}}, 0.0625);
}

TEST(QuadricManifold, OfALyingConeAreTheTipAndAPointOfItsRim) {
  const double half_angle = std::atan2(0.5, 2), degrees = half_angle * 180 / 3.14159265358979323846;
  const PosedQuadric cone(Cone(0.5, 1), {rotation_about({1, 0, 0}, -90 - degrees), {0, 0, std::sin(half_angle)}});
  const double along = std::cos(half_angle), whole = std::sqrt(4.25);
  expect_points(manifold(cone, table()), {{0, along, 0}, {0, along - whole, 0}}, 0);
}

TEST(QuadricManifold, OfTwoCapsAreTheEndsOfTheirLens) {
  const Manifold m = manifold(PosedQuadric(Cylinder(0.5, 1)), PosedQuadric(Cylinder(0.5, 1), placed_at(0.6, 0, 1.875)));
  EXPECT_EQ(m.normal, (Vec3{0, 0, 1}));
  expect_points(m, {{0.1, 0, 0.9375}, {0.5, 0, 0.9375}, {0.3, 0.4, 0.9375}, {0.3, -0.4, 0.9375}}, 0.125);
  // A sliver of a lens, of which no point of a rim that is counted is a part.
  const double apart = 1 - 1e-5, half_chord = std::sqrt(0.25 - apart * apart / 4);
  const Manifold sliver =
      manifold(PosedQuadric(Cylinder(0.5, 1)), PosedQuadric(Cylinder(0.5, 1), placed_at(apart, 0, 2 - 0x1p-30)));
  ASSERT_GE(sliver.count, 2);
  EXPECT_NEAR(std::fabs(position_of(sliver, 0).y), half_chord, 1e-9);
}

TEST(QuadricManifold, OfTwoCylindersSideBySideAreTheEndsOfTheirCommonLine) {
  const Manifold m = manifold(PosedQuadric(Cylinder(0.5, 1)), PosedQuadric(Cylinder(0.5, 1), placed_at(0.9375, 0, 1)));
  expect_points(m, {{0.46875, 0, 0}, {0.46875, 0, 1}}, 0.0625);
  const PosedQuadric crossed(Cylinder(0.5, 1), {rotation_about({1, 0, 0}, 90), {0.9375, 0, 0}});
  expect_points(manifold(PosedQuadric(Cylinder(0.5, 1)), crossed), {{0.46875, 0, 0}}, 0.0625);
}

// Beside where they cross the sides sink away from each other.
TEST(QuadricManifold, OfLinesThatNearlyLieAlongEachOtherIsOnBothSides) {
  const PosedQuadric pin(Cylinder(0.25, 2));
  const oracle::FineSet set = oracle::quadric_set(oracle::FineKind::cylinder, pin.half(), pin.pose());
  for (const double degrees : {0.0, 0.01, 0.125, 0.5, 1.5}) {
    const Pose leaning{rotation_about({1, 0, 0}, degrees), {0.46875, 0, 0.5}};
    const PosedQuadric other(Cylinder(0.25, 2), leaning);
    const Manifold beside = manifold(pin, other);
    const auto set_b = oracle::quadric_set(oracle::FineKind::cylinder, other.half(), leaning);
    EXPECT_EQ(quadric_manifold_fault(beside, set, set_b, 3), "") << degrees;
    EXPECT_GE(beside.count, 2) << degrees;
    const Pose turned = Pose{leaning.linear, {0.5625, 0, 0.5}} * Pose{rotation_about({0, 0, 1}, 45), {}};
    for (const PlacedPolytope& bar : {PlacedPolytope{Capsule({0, 0, -2}, {0, 0, 2}, 0.25), leaning},
                                      PlacedPolytope{Box({0.25, 0.25, 2}), turned}}) {
      const Manifold m = manifold(pin, posed(bar));
      EXPECT_EQ(quadric_manifold_fault(m, set, fine_set(bar), 3), "") << degrees;
      EXPECT_GE(m.count, 2) << degrees;
    }
  }
}

TEST(QuadricManifold, OfAnEllipsoidIsOnePoint) {
  expect_points(manifold(PosedQuadric(Ellipsoid({0.5, 0.25, 0.75}), placed_at(1, 0, 0.5)), table()), {{1, 0, -0.125}},
                0.25);
  expect_points(manifold(PosedQuadric(Ellipsoid({1, 1, 2})), PosedQuadric(Ellipsoid({1, 2, 1}), placed_at(1.75, 0, 0))),
                {{0.875, 0, 0}}, 0.25);
}

TEST(QuadricManifold, OnACapIsWhatTheOtherShapeHasThere) {
  const PosedQuadric can(Cylinder(0.5, 1));
  expect_points(manifold(can, PosedPolytope(Sphere(0.25), placed_at(0.125, 0, 1.1875))), {{0.125, 0, 0.96875}}, 0.0625);
  const PosedPolytope capsule(Capsule({-1, 0, 0}, {1, 0, 0}, 0.25), placed_at(0, 0, 1.1875));
  expect_points(manifold(can, capsule), {{-0.5, 0, 0.96875}, {0.5, 0, 0.96875}}, 0.0625);
  const PosedPolytope ridge(Box({0.5, 1, 0.5}), {rotation_about({0, 1, 0}, 45), {0.3, 0, 1 + std::sqrt(0.5) - 0.0625}});
  expect_points(manifold(can, ridge), {{0.3, -0.4, 0.96875}, {0.3, 0.4, 0.96875}}, 0.0625);
}

TEST(QuadricManifold, OfARimOnAnEdgeIsOnePoint) {
  const PosedPolytope beam(Box({0.25, 4, 0.25}), {rotation_about({0, 1, 0}, 45), {0, 0, -0.25 * std::sqrt(2.0)}});
  const double height = std::sqrt(0.75) + 0.25, depth = 0.0625;
  const PosedQuadric tilted(Cylinder(0.5, 1), {rotation_about({1, 0, 0}, 30), {0, 0, height - depth}});
  const Manifold m = manifold(tilted, beam);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.points[0].depth, depth, 1e-12);
  EXPECT_EQ(m.points[0].on_a.kind, ConvexFeature::Kind::edge);
  EXPECT_EQ(m.points[0].on_b.kind, ConvexFeature::Kind::edge);
}

// A needle that stands, a little askew, on an edge a million times as long as its cap is wide.
TEST(QuadricManifold, OfAnEdgeAcrossASlimCapIsOnBoth) {
  Random random(11);
  for (int i = 0; i < 40; ++i) {
    const double radius = random.between(1e-6, 4e-6), depth = std::pow(10.0, random.between(-9, -7));
    const Mat3 askew = rotation_about(quadric_direction(random), random.between(0.1, 1));
    const PlacedQuadric needle{Cylinder(radius, 1), {askew, {}}};
    const oracle::FineSet at_origin = fine_set(needle);
    const double lowest = oracle::farthest(at_origin, fine_of({0, 0, -1})).z.convert_to<double>();
    const PlacedPolytope roof{
        Box({1, 2, 1}),
        {rotation_about({0, 1, 0}, 45),
         {random.between(-1, 1) * radius, random.between(-1, 1), lowest + depth - std::sqrt(2.0)}}};
    const Vec3 below = transform(needle.pose, {0, 0, -1});
    PlacedPolytope moved = roof;
    moved.pose.offset = roof.pose.offset + Vec3{below.x, below.y, 0};
    const Manifold m = manifold(posed(needle), posed(moved));
    if (m.count == 0) continue;
    EXPECT_EQ(quadric_manifold_fault(m, at_origin, fine_set(moved), 3), "") << i;
  }
}

// The tip is a point of the other one's base; behind it the cones go through each other.
TEST(QuadricManifold, OfATipThatTouchesABaseFromWithinIsDeep) {
  const PlacedQuadric upright{Cone(3, 3), {}}, hanging{Cone(1, 3), {rotation_about({1, 0, 0}, 180), {-2, 2, 0}}};
  EXPECT_EQ(quadric_contact(posed(upright), posed(hanging)), QuadricContact::contact);
  const Manifold m = manifold(posed(upright), posed(hanging));
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.points[0].depth, (3 - std::sqrt(8)) * 2 / std::sqrt(5), 1e-13);
  EXPECT_EQ(quadric_manifold_fault(m, fine_set(upright), fine_set(hanging), 3), "");
}

// The side of a cone 3 wide and 4 high leans by 3 : 4; a crate lies on it.
TEST(QuadricManifold, OfSlopesThatTouchHasTheirNormal) {
  const PosedQuadric cone(Cone(3, 2));
  const Mat3 sloped{{Vec3{0.6, 0, 0.8}, Vec3{0, 1, 0}, Vec3{-0.8, 0, 0.6}}};
  const Manifold on_side = manifold(cone, PosedPolytope(Box({1, 1, 1}), {sloped, {1.5 + 0.8, 0, 0.6}}));
  ASSERT_EQ(on_side.count, 2);
  EXPECT_NEAR(dot(on_side.normal, Vec3{0.8, 0, 0.6}), 1, 1e-15);
  EXPECT_NEAR(on_side.points[0].depth, 0, 1e-15);
  const PosedQuadric other(Cone(3, 2), {rotation_about({1, 0, 0}, 180), {3, 0, 0}});
  const Manifold of_lines = manifold(cone, other);
  ASSERT_EQ(of_lines.count, 2);
  EXPECT_NEAR(dot(of_lines.normal, Vec3{0.8, 0, 0.6}), 1, 1e-15);
}

// Both orders are one question: nothing tells A from B.
TEST(QuadricManifold, OfEqualShapesAtOnePlaceIsOneAnswer) {
  for (const QuadricShape& shape :
       {QuadricShape(Cylinder(3, 2)), QuadricShape(Cone(1, 2)), QuadricShape(Ellipsoid({1, 2, 3}))}) {
    const PlacedQuadric placed{shape, placed_at(1, 2, 3)};
    const Manifold m = manifold(posed(placed), posed(placed));
    EXPECT_EQ(quadric_manifold_fault(m, fine_set(placed), fine_set(placed), 3), "");
    const Manifold again = manifold(posed(placed), posed(placed));
    EXPECT_EQ(m.normal, again.normal);
    EXPECT_EQ(sorted_positions(m), sorted_positions(again));
  }
}

TEST(QuadricManifold, HoldsForAffineImages) {
  Pose sheared = placed_at(0.25, 0, 1);
  sheared.linear[0] = {1.5, 0, 0.5};
  const Manifold m = manifold(PosedQuadric(Cylinder(0.5, 1), sheared), table());
  expect_points(m, {{-1, 0, 0}, {0.5, 0, 0}, {-0.25, 0.5, 0}, {-0.25, -0.5, 0}}, 0);
}

TEST(QuadricManifold, OnAHalfSpace) {
  const PosedHalfSpace ground(HalfSpace({0, 0, 0}, {0, 0, 2}));
  const Manifold m = manifold(PosedQuadric(Cylinder(0.5, 1), placed_at(0, 0, 0.9375)), ground);
  EXPECT_EQ(m.normal, (Vec3{0, 0, -1}));
  expect_points(m, {{part, part, -0.03125}, {-part, part, -0.03125}, {part, -part, -0.03125}, {-part, -part, -0.03125}},
                0.0625);
  EXPECT_EQ(manifold(ground, PosedQuadric(Cylinder(0.5, 1), placed_at(0, 0, 1.5))).count, 0);
  // Tilted a little, the lowest point comes first, and the others stay within the gap of what rests.
  const PosedQuadric tilted(Cylinder(0.5, 1), {rotation_about({1, 0, 0}, 0.01), {0, 0, 1}});
  const Manifold lean = manifold(tilted, ground);
  ASSERT_EQ(lean.count, 4);
  EXPECT_LT(position_of(lean, 0).y, -0.49);
  EXPECT_LT(lean.points[1].depth, 0);
}

TEST(QuadricManifold, OfATriangleIsDefined) {
  const PosedPolytope floor(Triangle{{{{-2, -2, 0}, {2, -2, 0}, {0, 2, 0}}}});
  const Manifold m = manifold(floor, PosedQuadric(Cylinder(0.5, 1), placed_at(0, 0, 1 - 0.0625)));
  EXPECT_EQ(m.count, 4);
  EXPECT_EQ(m.normal, (Vec3{0, 0, 1}));
}

TEST(QuadricManifold, IsEmptyExactlyWhenTheShapesAreApart) {
  EXPECT_EQ(manifold(PosedQuadric(Cylinder(0.5, 1), placed_at(0, 0, 1.001)), table()).count, 0);
  EXPECT_EQ(manifold(PosedQuadric(Ellipsoid({1, 1, 1}), placed_at(0, 0, 1.001)), table()).count, 0);
}

TEST(QuadricManifold, HoldsTheRegionOfContact) {
  const auto set_of = [](const PosedQuadric& can) {
    return oracle::quadric_set(oracle::FineKind::cylinder, can.half(), can.pose());
  };
  const oracle::FineSet box = fine_set(PlacedPolytope{Box({2, 2, 0.5}), placed_at(0, 0, -0.5)});
  for (const double x : {0.0, 1.75, 2.0, 2.25})
    for (const double y : {0.0, 1.9, 2.2}) {
      const PosedQuadric can(Cylinder(0.5, 1), placed_at(x, y, 0.9375));
      const Manifold m = manifold(can, table());
      ASSERT_GT(m.count, 0);
      EXPECT_EQ(quadric_manifold_fault(m, set_of(can), box, 2), "") << x << " " << y;
      EXPECT_EQ(contact_extent_fault(m, set_of(can), box, 2), "") << x << " " << y;
    }
}

}  // namespace
}  // namespace toccata::test
