// Witnesses of quadrics: with a constant that a proof rests on made a few times too small, these doubles give a false
// statement (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "narrow/quadrics/distance/fast_proof.hpp"
#include "narrow/quadrics/distance/fast_refinement.hpp"
#include "oracle/rational.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

using oracle::exact;

// --- Answers that are a few times the least double: rounded to nearest, one end of an interval would pass the truth.

constexpr double least_double = std::numeric_limits<double>::denorm_min();

PosedQuadric tiny_ball(double radius, const Vec3& centre) {
  const double r = radius * least_double;
  return PosedQuadric(Ellipsoid({r, r, r}), {{}, least_double * centre});
}

/// In units of the least double, exactly.
oracle::Rational in_least_doubles(double length) { return exact(length) / exact(least_double); }

oracle::Rational square_of(const oracle::Rational& x) { return x * x; }

// A ball of radius r, whose centre is s / √q above the plane or below it: between them are s / √q − r, and the depth is
// s / √q + r.
TEST(QuadricProofConstants, AHeightOfLeastDoublesIsRoundedBothWays) {
  const Distance less = distance(tiny_ball(27, {121, 85, 154}), PosedHalfSpace(HalfSpace({0, 0, 0}, {0, 1, 3})));
  EXPECT_LE(square_of(in_least_doubles(less.lower) + 27) * 10, square_of(85 + 3 * 154));
  const Distance more = distance(tiny_ball(2, {19, 161, 114}), PosedHalfSpace(HalfSpace({0, 0, 0}, {0, 2, 3})));
  EXPECT_GE(square_of(in_least_doubles(more.upper) + 2) * 13, square_of(2 * 161 + 3 * 114));
}

TEST(QuadricProofConstants, ADepthOfLeastDoublesInAHalfSpaceIsRoundedBothWays) {
  const Penetration less =
      penetration(tiny_ball(27, {-121, -85, -154}), PosedHalfSpace(HalfSpace({0, 0, 0}, {0, 1, 3})));
  EXPECT_LE(square_of(in_least_doubles(less.lower) - 27) * 10, square_of(85 + 3 * 154));
  const Penetration more =
      penetration(tiny_ball(2, {-19, -161, -114}), PosedHalfSpace(HalfSpace({0, 0, 0}, {0, 2, 3})));
  EXPECT_GE(square_of(in_least_doubles(more.upper) - 2) * 13, square_of(2 * 161 + 3 * 114));
}

// Of balls, between them is the distance of the centres less both radii, and the depth is the opposite.
TEST(QuadricProofConstants, ADistanceOfLeastDoublesIsRoundedBothWays) {
  const Distance less = distance(tiny_ball(27, {0, 0, 0}), tiny_ball(2, {45, 54, 56}));
  EXPECT_LE(square_of(in_least_doubles(less.lower) + 27 + 2), 45 * 45 + 54 * 54 + 56 * 56);
  const Distance more = distance(tiny_ball(8, {0, 0, 0}), tiny_ball(2, {59, 41, 14}));
  EXPECT_GE(square_of(in_least_doubles(more.upper) + 8 + 2), 59 * 59 + 41 * 41 + 14 * 14);
}

TEST(QuadricProofConstants, ADepthOfLeastDoublesOfTwoQuadricsParts) {
  const Penetration found = penetration(tiny_ball(29, {0, 0, 0}), tiny_ball(38, {9, 50, 3}));
  const oracle::Rational still_between = oracle::Rational(29 + 38) - in_least_doubles(found.upper);
  EXPECT_LE(still_between * still_between, 9 * 9 + 50 * 50 + 3 * 3);
}

// --- Intervals from a point of each shape and a direction.

/// A vertex, or an end of the axis, alone.
FastSide side_at(Index generator) {
  FastSide side;
  side.size = 1;
  side.generator[0] = generator;
  side.weight = {1, 0, 0};
  return side;
}

// The tip of a cone and a point above it: their distance is rounded down by 3 · 2^-53 of it.
TEST(QuadricProofConstants, ALengthThatIsRoundedDownIsNoUpperEnd) {
  const Vec3 middle{-0x1.513b3489d6366p-2, 0x1.0cf01221532cp-2, -0x1.2c47aad687a9p-4};
  const Vec3 point{-0x1.5139a27fa67f1p-2, 0x1.0cefc37191604p-2, 0x1.eaf7dcfb23086p+1};
  const auto way = exact(middle) + exact(Vec3{0, 0, 1}) - exact(point);
  const FastDistance found = proved_interval(PosedQuadric(Cone(1, 1), {{}, middle}), PosedPolytope(Point{point}),
                                             side_at(1), side_at(0), oracle::rounded(way));
  EXPECT_GE(square_of(exact(found.upper)), oracle::dot(way, way));
}

// The first two columns of the pose are nearly parallel, and products with them are mere rounding: what they are off by
// hides by how much the direction leans.
TEST(QuadricProofConstants, ProductsWithColumnsThatAreNearlyParallelAreRounded) {
  const Mat3 linear{{Vec3{0x1.0b68bcf62dc49p-2, 0x1.0b80d8e444052p-2, 0x1.34fa5dc4d191ap-1},
                     Vec3{0x1.5ff77dcd1f0e3p-1, 0x1.5ffc30f26db3bp-1, -0x1.54110b4dcc5p-1},
                     Vec3{-0x1.5af7b1e319042p-1, -0x1.5aee483957b3p-1, -0x1.c3cd613eb9b4ep-2}}};
  const Vec3 point{0x1.34f677a085f75p-1, -0x1.5417887fcfe52p-1, -0x1.c3dd8cc6f0d0ap-2};
  const Vec3 direction{-0x1.34fa5dc4d0451p-1, 0x1.54110b4dccd1ap-1, 0x1.c3cd613ebbbc4p-2};
  FastSide on_end = side_at(1);
  on_end.round = {-0x1.6666666666666p-1, 0x1.6666666666666p-1, 0};
  const FastDistance found = proved_interval(PosedQuadric(Cylinder(1, 1), {linear, {0, 0, 0}}),
                                             PosedPolytope(Point{point}), on_end, side_at(0), direction);
  // The nearest point lies in the plane of the upper end.
  const auto normal = oracle::cross(exact(linear.column(0)), exact(linear.column(1)));
  const oracle::Rational height = oracle::dot(normal, exact(point) - exact(linear.column(2)));
  EXPECT_LE(square_of(exact(found.lower)) * oracle::dot(normal, normal), height * height);
}

// The tip of a cone just beyond an edge of a triangle, whose weights add up to more than 1 by a rounding: it is nearer
// to the point that they make than to the triangle.
TEST(QuadricProofConstants, WeightsThatAddUpToMoreThanOneMakeAPointOutside) {
  const Vec3 middle{-0x1.2668615b1fb9ap-2, -0x1.bb714d3d1da5ap-2, -0x1.968bd4ca71f26p+0};
  const std::array<Vec3, 3> corner{Vec3{0x1.98540e3c12ddep-1, -0x1.8b8370e45d24ap-2, 0x1.89c206372c664p-1},
                                   Vec3{-0x1.36cd9d821c03p-1, -0x1.9f9e1f71b592cp-2, -0x1.afdce2632dc86p-2},
                                   Vec3{0x1.38dc4d9a19544p-2, -0x1.ef15a6fe47918p-2, -0x1.cb25e6f8e6d36p-1}};
  const Vec3 outwards{-0x1.db468cd67a4c9p-2, -0x1.585dcd4c50b32p-5, -0x1.c500032df06e9p-1};
  FastSide on_edge = side_at(0);
  on_edge.size = 3;
  on_edge.generator = {0, 1, 2};
  on_edge.weight = {0, 0x1.4cb9d5bf753c4p-1, 0x1.668c548115879p-2};
  const FastDistance found = proved_interval(PosedQuadric(Cone(0x1p-3, 1), {{}, middle}),
                                             PosedPolytope(Triangle{corner}), side_at(1), on_edge, outwards);
  const auto edge = exact(corner[2]) - exact(corner[1]);
  const auto across = oracle::cross(exact(middle) + exact(Vec3{0, 0, 1}) - exact(corner[1]), edge);
  EXPECT_GE(square_of(exact(found.upper)) * oracle::dot(edge, edge), oracle::dot(across, across));
}

}  // namespace
}  // namespace toccata
