// Witnesses of quadrics: with a constant that a proof rests on made a few times too small, these doubles give a false
// statement (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "narrow/quadrics/depth/quadric_expansion.hpp"
#include "narrow/quadrics/distance/axial_box.hpp"
#include "narrow/quadrics/distance/axial_proof.hpp"
#include "narrow/quadrics/distance/ellipsoid_pair.hpp"
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

// The distance between balls is that of the centres less both radii, and the depth is the opposite.
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

// --- Intervals of two ellipsoids.

PosedQuadric ball(double radius, const Vec3& centre) {
  return PosedQuadric(Ellipsoid({radius, radius, radius}), {{}, centre});
}

// Two balls that are so small that no difference of coordinates is what it should be: all are rounded the same way.
TEST(QuadricProofConstants, ADistanceOfSmallBallsIsRoundedBothWays) {
  const double r = 0x1.c0db7ab224cfp-53, s = 0x1.c7d8d380fcb4ep-53;
  const Vec3 p{0x1.00000000001a1p+0, 0x1.00000000001f5p+0, 0x1.000000000009bp+0};
  const Vec3 q{-0x1.e89a8637bea8dp-54, -0x1.d4f2fddc1afdp-54, -0x1.f1571fa48daacp-54};
  const auto less = ellipsoid_distance(ball(r, p), ball(s, q), {});
  ASSERT_TRUE(less);
  EXPECT_GE(square_of(exact(less->upper) + exact(r) + exact(s)), oracle::dot(exact(p) - exact(q), exact(p) - exact(q)));

  const double t = 0x1.839c492f8bd2ep-53, v = 0x1.b71e0778e6cfdp-53;
  const Vec3 x{0x1.00000000003dap+0, 0x1.0000000000094p+0, 0x1.0000000000141p+0};
  const Vec3 y{-0x1.e2c6ab83fa87ep-54, -0x1.fb701fed8c27ap-54, -0x1.d458be249ae8p-54};
  const auto more = ellipsoid_distance(ball(t, x), ball(v, y), {});
  ASSERT_TRUE(more);
  EXPECT_LE(square_of(exact(more->lower) + exact(t) + exact(v)), oracle::dot(exact(x) - exact(y), exact(x) - exact(y)));
}

/// No less than the root, and by no more than a part of 2^-100: one step of Newton's from the rounded one.
oracle::Rational root_from_above(const oracle::Rational& square) {
  const oracle::Rational root = exact(std::sqrt(square.to_double()));
  return (root + square / root) / oracle::Rational(2);
}

/// An ellipsoid seen along a direction, exactly but for roots that are a little too large.
struct SeenEllipsoid {
  SeenEllipsoid(const Vec3& half, const Pose& pose, const oracle::RationalPoint& direction) {
    const auto column = [&](int j) { return exact(half[j]) * exact(pose.linear.column(j)); };
    oracle::Rational squared;
    for (int j = 0; j < 3; ++j) squared += square_of(oracle::dot(column(j), direction));
    reach = root_from_above(squared);
    farthest = exact(pose.offset);
    for (int j = 0; j < 3; ++j) farthest = farthest + (oracle::dot(column(j), direction) / reach) * column(j);
  }
  oracle::Rational reach;          ///< from the middle, times the direction's length
  oracle::RationalPoint farthest;  ///< one of its points
};

// Needles of which each lies across the other's way, so that the points of a needle are far greater than what it
// reaches along the direction.
const Vec3 long_needle{0x1.a4d7aa4eca034p+0, 0x1.27540ccfd8d39p-5, 0x1.2e2d783ae52d1p-5};
const Pose place_of_long_needle{{{Vec3{0x1.566acd4602c28p-2, -0x1.c34daa61e1363p-1, 0x1.5581f78641658p-2},
                                  Vec3{-0x1.c11d48a26c583p-1, -0x1.ae949b8d9adbp-2, -0x1.dacfbfb356337p-3},
                                  Vec3{0x1.60dca5e893416p-2, -0x1.b85a1b8a7256dp-3, -0x1.d3dd312a5e7f4p-1}}},
                                {-0x1.c72c6b9cc3c94p-2, 0x1.43dadcfe8edecp+0, -0x1.f474ff6d7d60cp-2}};
const Vec3 short_needle{0x1.7c6e737e4f152p-6, 0x1.28e931afd22edp-11, 0x1.027bfd4751a07p-11};
const Pose place_of_short_needle{{{Vec3{-0x1.1602607bc1eap-2, 0x1.753e70a78df32p-1, -0x1.41bb147cfb068p-1},
                                   Vec3{-0x1.643d34e9096b4p-1, 0x1.35b28a232490cp-2, 0x1.4d8e54673ad3dp-1},
                                   Vec3{0x1.5476aa783f16ep-1, 0x1.3a6974671fa9dp-1, 0x1.b34f6126517b2p-2}}},
                                 {-0x1.e0a2647439c89p-32, 0x1.e5ff1579cea0fp-31, 0x1.42729f6948b4ep-34}};

TEST(QuadricProofConstants, PointsOfEllipsoidsAreRoundedAsTheirLongestAxesAre) {
  const auto direction = exact(Vec3{0x1.7fd6fe8715b29p-1, 0x1.fe6b035e98f81p-2, 0x1.bdc6fddbf517fp-2});
  const auto found = ellipsoid_distance(PosedQuadric(Ellipsoid(long_needle), place_of_long_needle),
                                        PosedQuadric(Ellipsoid(short_needle), place_of_short_needle), {});
  ASSERT_TRUE(found);
  const oracle::Rational apart =
      oracle::dot(exact(place_of_long_needle.offset) - exact(place_of_short_needle.offset), direction) -
      SeenEllipsoid(long_needle, place_of_long_needle, direction).reach -
      SeenEllipsoid(short_needle, place_of_short_needle, direction).reach;
  EXPECT_GE(exact(found->upper) * root_from_above(oracle::dot(direction, direction)), apart);
}

TEST(QuadricProofConstants, WhatEllipsoidsReachBeyondTheirPointsIsRoundedAsTheirLongestAxesAre) {
  const Vec3 half_a{0x1.b246bc54f586ep+0, 0x1.b9827d36d746dp-6, 0x1.3cf4a713ae819p-5};
  const Vec3 half_b{0x1.7af6e16a1196ap+0, 0x1.c67da5baa74a5p-5, 0x1.0391b1fe2a5bdp-3};
  const Pose pose_a{{{Vec3{-0x1.78a126df30048p-1, 0x1.75261bfe432aap-2, 0x1.246076e2c0359p-1},
                      Vec3{-0x1.02658ad6c7ca6p-1, 0x1.11ecef91c781ep-2, -0x1.a441ebfd28524p-1},
                      Vec3{-0x1.ceb60af39a30dp-2, -0x1.c8b3482912654p-1, -0x1.a5c04d9dcdf8p-7}}},
                    {-0x1.fc331aa67310cp+0, -0x1.0fe58bbda8e7p+1, -0x1.0a567c5167016p+0}};
  const Pose pose_b{{{Vec3{-0x1.f7272f6c89bc8p-2, 0x1.92e6642b2ebc8p-1, 0x1.7e3ac68021b88p-2},
                      Vec3{-0x1.b487a2ec0f4ep-1, -0x1.6362ca6bcb64cp-2, -0x1.900dfb05596fbp-2},
                      Vec3{-0x1.6c4e7c475f578p-3, -0x1.053abe2341422p-1, 0x1.aed29d746581ap-1}}},
                    {-0x1.4ffee11974dc1p-32, -0x1.f4fbc89597641p-32, 0x1.c1b184bf4593fp-33}};
  const auto direction = exact(Vec3{-0x1.3efad58bd8c44p-1, -0x1.3ace50d9826ecp-1, -0x1.ef261da7dd2b8p-2});
  const auto found =
      ellipsoid_distance(PosedQuadric(Ellipsoid(half_a), pose_a), PosedQuadric(Ellipsoid(half_b), pose_b), {});
  ASSERT_TRUE(found);
  const auto way =
      SeenEllipsoid(half_a, pose_a, -direction).farthest - SeenEllipsoid(half_b, pose_b, direction).farthest;
  EXPECT_LE(square_of(exact(found->lower)), oracle::dot(way, way));
}

// --- The interval of a cylinder about the third axis and a speck of a box.

/// Both, the direction from the box to the cylinder, and the points of both that are nearest to each other, but for
/// what is far less than a rounding: the corner that is greatest in all coordinates, and a point of the rim.
struct SmallCylinderAndSpeck {
  [[nodiscard]] FastDistance distance() const {
    const PosedQuadric cylinder(Cylinder(radius, half_height), {{}, middle});
    return axial_box_distance(cylinder, PosedPolytope(Box({speck, speck, speck}), {{}, middle_of_speck})).value();
  }
  [[nodiscard]] oracle::RationalPoint direction() const { return exact(middle) - exact(middle_of_speck); }
  /// From the corner to the rim.
  [[nodiscard]] oracle::RationalPoint way() const {
    const auto d = direction();
    const oracle::Rational part = exact(radius) / root_from_above(d.x * d.x + d.y * d.y);
    const oracle::RationalPoint to_rim{part * d.x, part * d.y, exact(half_height)};
    return exact(middle) - to_rim - exact(middle_of_speck + Vec3{speck, speck, speck});
  }
  double radius;
  double half_height;
  Vec3 middle;
  Vec3 middle_of_speck;
  double speck = 0x1p-63;
};

// No difference of coordinates is what it should be, and all are rounded the same way. A little less than what lies
// between the two planes across the direction is less than the distance, and the way between two points is not.
TEST(QuadricProofConstants, ADistanceOfASmallCylinderAndABoxIsRoundedBothWays) {
  const SmallCylinderAndSpeck less{0x1.78a67af50f75bp-53,
                                   0x1.02e338cab953bp-53,
                                   {0x1.0543dcc2e79aap+0, 0x1.0a910d413d98dp+0, 0x1.0131496fa44adp+0},
                                   {-0x1.e8b3163091b76p-54, -0x1.ce03e83b9a3f9p-54, -0x1.f72fc8ce3ada2p-54}};
  const auto d = less.direction();
  const oracle::Rational apart = oracle::dot(less.way(), d) / root_from_above(oracle::dot(d, d));
  EXPECT_GE(exact(less.distance().upper), (1 - exact(0x1p-90)) * apart);

  const SmallCylinderAndSpeck more{0x1.6026a4e9f9661p-53,
                                   0x1.e7de36222cd5dp-54,
                                   {0x1.013099a0e2b83p+0, 0x1.0946cefa1baaap+0, 0x1.0914fbaa1c944p+0},
                                   {0x1.ed352747ba49fp-54, 0x1.ed12407bacd14p-54, 0x1.e19772d60a485p-54}};
  EXPECT_LE(square_of(exact(more.distance().lower)), oracle::dot(more.way(), more.way()));
}

// --- Statements that those intervals rest on, which what else is added to them would hide.

// How wide the cone is at the point, the direction and its length are all rounded outwards.
TEST(QuadricProofConstants, APointOfARoundSideIsDrawnInAsFarAsItMayBeRoundedOutwards) {
  const Vec3 half{0x1.fa477a996ef99p-1, 0x1.fa477a996ef99p-1, 0x1.b1f15cff67c8ep-1};
  const AxialFoot foot{.out = 2, .up = 0x1.44aa50b29c5b9p-2};
  const Vec3 p = drawn_in_foot<ConeKind>(half, foot, -0x1.02835cb6c62p-1, -0x1.b9f1cc24731d1p-1);
  const oracle::Rational wide = exact(half.x) * (exact(half.z) - exact(p.z)) / (2 * exact(half.z));
  EXPECT_LE(square_of(exact(p.x)) + square_of(exact(p.y)), wide * wide);
}

TEST(QuadricProofConstants, APointOfAnEllipsoidIsDrawnInAsFarAsItMayBeRoundedOutwards) {
  const Vec3 half{0x1.7e4e02e5abcecp-1, 0x1.ea161f0fbbcb8p-1, 0x1.37aa255d2e1e9p-1};
  const Vec3 along{0x1.3239055151077p-1, 0x1.fdd4aba2c958fp-1, 0x1.ab2b81e3560f7p-1};
  const Vec3 round = drawn_into_ball(along, plain_length(along));
  oracle::Rational squared;
  for (int i = 0; i < 3; ++i) squared += square_of(exact(half[i] * round[i]) / exact(half[i]));
  EXPECT_LE(squared, 1);
}

// A flat cylinder and a point of its lower rim, against a direction in which that is the nearest. The pose is none, so
// that the products with its columns are the direction.
TEST(QuadricProofConstants, WhatACylinderReachesBeyondAPointOfItsRimIsRounded) {
  const double r = 0x1.e7fc5a1a4836cp-1, h = 0x1.2e9ee2b50175cp-4;
  const Vec3 n{0x1.04731224609a4p-1, -0x1.dccfb6a1c8015p-1, -0x1.c7812781fe2a7p-6};
  const Vec3 p{0x1.d3dbe586eced7p-2, -0x1.ac42b293a9ca5p-1, -h};
  const oracle::Rational across = root_from_above(square_of(exact(n.x)) + square_of(exact(n.y)));
  const oracle::Rational reach = exact(r) * across + exact(h) * exact(-n.z) + oracle::dot(exact(n), exact(p));
  // The root is too large by less than a part of 2^-100.
  const oracle::Rational beyond = exact(beyond_axial<CylinderKind>({r, r, h}, p, n)) + exact(0x1p-99);
  const oracle::Rational length = root_from_above(oracle::dot(exact(n), exact(n)));
  EXPECT_GE(beyond + exact(rounding_beyond(r, h, 0, true)) * length, reach);
}

/// A body that is a point, each of whose coordinates is a number and a little more.
QuadricBody body_at(const Vec3& point, const Vec3& more) {
  BoundedVector sum;
  for (int i = 0; i < 3; ++i) sum[static_cast<std::size_t>(i)] = exactly(point[i]) + exactly(more[i]);
  return QuadricBody(sum);
}

// A − B has a point that is (-s, -s, 2^-20) and in doubles (0, 0, 2^-20), along the directions around the third axis.
TEST(QuadricProofConstants, WhereTheHighestPointOfACapLiesIsRounded) {
  const double height = 0x1p-20, tangent = 0x1p-13, least = height * (1 - 0x1p-27), s = 0x1.74p-53;
  const QuadricBody a = body_at({1, 1, 1 + height}, {-0x1.fp-55, -0x1.fp-55, 0});
  const QuadricBody b = body_at({1, 1, 1}, {0x1.fp-54, 0x1.fp-54, 0});
  ASSERT_EQ(a.plain_centre(0) - b.plain_centre(0), (Vec3{0, 0, height}));
  const std::array<GeneratorPair, 1> pair{};
  const double proved = QuadricCap(a, b, {0, 0, 1}, pair).proved_height(tangent, least);
  ASSERT_GT(proved, 0);
  // At the rim, farthest from the point.
  const double x = 0x1.6a09e667f3bccp-1 * tangent;
  const oracle::RationalPoint rim = exact(Vec3{x, x, 1});
  ASSERT_LE(2 * x * x, tangent * tangent);
  const oracle::Rational reach = oracle::dot(rim, exact(Vec3{-s, -s, height}));
  EXPECT_LE(square_of(exact(std::fmin(proved, least))) * oracle::dot(rim, rim), reach * reach);
}

// The axis is longer than 1 by a rounding, and the quotient, its square and the root are rounded down.
TEST(QuadricProofConstants, TheCapOfARaisedCornerIsAsWideAsItsAxisIsLong) {
  const auto axis = exact(Vec3{-0x1.4ca6c709d63edp-1, -0x1.d505fc69827a7p-2, 0x1.36a163c1dda62p-1});
  const double times = 0x1.8ff69fd0f2103p-1, least = 0x1.8ff682fef3b58p-1;
  EXPECT_GE((1 + square_of(exact(tangent_of_raised(times, least)))) * square_of(exact(least)),
            square_of(exact(times)) * oracle::dot(axis, axis));
}

// --- Where the line between the middles tells, or the middles' plane does.

// Ellipsoids of one shape and one orientation are apart where, in their own half axes, the way between the middles is
// longer than 2.
TEST(QuadricProofConstants, EllipsoidsThatAreApartByARoundingDoNotMeetBetweenTheirMiddles) {
  const Vec3 half{0x1.137feaef76f19p+0, 0x1.37e62eedf6686p-3, 0x1.307e94ed797f6p-2};
  const Vec3 way{0x1.fab730c2d4806p-7, 0x1.1a012e2c5a661p-2, 0x1.0420deb816ab4p-2};
  oracle::Rational squared;
  for (int i = 0; i < 3; ++i) squared += square_of(exact(way[i]) / exact(half[i]));
  ASSERT_GT(squared, 4);
  EXPECT_NE(ellipsoid_contact(PosedQuadric(Ellipsoid(half)), PosedQuadric(Ellipsoid(half), {{}, way})),
            QuadricContact::contact);
}

// Both are smaller than told by a part of 2^-23, which their pose says. In units of their half axes the middles are
// 2 (1 - 2^-23) (1 + 2^-26) apart, and the radii are 1 - 2^-23.
TEST(QuadricProofConstants, APoseThatShrinksIsNoRotation) {
  const double s = 1 - 0x1p-23, apart = s * (1 + 0x1p-26);
  const Mat3 shrinking{{Vec3{s, 0, 0}, Vec3{0, s, 0}, Vec3{0, 0, s}}};
  const Ellipsoid shape({0.625, 0.15625, 0.15625});
  const Vec3 middle{0.375 * apart, 0.125 * apart, 0};
  EXPECT_NE(ellipsoid_contact(PosedQuadric(shape, {shrinking, -middle}), PosedQuadric(shape, {shrinking, middle})),
            QuadricContact::contact);
}

// The middle of the box lies above that of the cylinder, but for so little that its square is lost. An edge of the box
// enters the cylinder beside its axis.
TEST(QuadricProofConstants, ACylinderSeenNearlyAlongItsAxisHasAWidth) {
  const PosedQuadric cylinder(Cylinder(1, 1));
  const Mat3 turn{{Vec3{0.8, 0, 0.6}, Vec3{0, 1, 0}, Vec3{-0.6, 0, 0.8}}};
  const PosedPolytope box(Box({1.92, 0.5, 1.06}), {turn, {0x1p-28, 0, 3 - 0x1p-32}});
  // Both ends of the edge, and the middle, which is in the cylinder.
  const Vec3 end = box.vertex(1), other = box.vertex(3);
  ASSERT_EQ(end.y, -other.y);
  for (const Vec3& v : {end, other}) ASSERT_TRUE(v.x > 0 && v.x < 1 && v.z > 0 && v.z < 1);
  EXPECT_NE(axial_box_contact(cylinder, box), QuadricContact::apart);
}

// The pose makes the cylinder thinner by a part of 2^-44. The box is a speck within the radius that is told, and beyond
// the one that is.
TEST(QuadricProofConstants, ACylinderIsAsThinAsItsPoseMakesIt) {
  const double s = 1 - 0x1p-44;
  const PosedQuadric cylinder(Cylinder(1, 1), {{{Vec3{s, 0, 0}, Vec3{0, s, 0}, Vec3{0, 0, s}}}, {0, 0, 0}});
  const PosedPolytope speck(Box({0x1p-60, 0x1p-60, 0x1p-60}), {{}, {1 - 0x1p-45, 0, 0}});
  for (Index i = 0; i < 8; ++i) ASSERT_GT(speck.vertex(i).x, s);
  EXPECT_NE(axial_box_contact(cylinder, speck), QuadricContact::contact);
}

}  // namespace
}  // namespace toccata
