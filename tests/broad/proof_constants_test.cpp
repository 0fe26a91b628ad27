// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include "broad/exact_balls.hpp"
#include "broad/own_bounds.hpp"
#include "oracle/rational.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/broad/space_time.hpp"

namespace toccata {
namespace {

using oracle::exact;

// Apart by so little that the squares round to the wrong order.
TEST(ProofConstants, BallsThatAreAlmostInTouchAreDecidedExactly) {
  const Ball a{{0x1.a1d7d9ad45d5ep+0, 0x1.435e9ee1733f2p+0, 0x1.07707d9a3513p+0}, 0x1.5e44e5bb8bf6p-2};
  const Ball b{{0x1.187ae08cdf17ap-4, 0x1.277cacd33e1f8p-4, 0x1.1e89b4eca642dp-4}, 0x1.d858272800a53p+0};
  const auto way = exact(a.centre) - exact(b.centre);
  const auto reach = exact(a.radius) + exact(b.radius);
  ASSERT_GT(oracle::dot(way, way), reach * reach);
  EXPECT_FALSE(balls_meet(a, b));
}

// 1 - 2^-55 and 1 + 2^-55 round to 1.
TEST(ProofConstants, ABoxGrowsByAMarginThatRoundsToNothing) {
  const double margin = 0x1p-55;
  const Aabb box = offset_outward(Aabb{{1, 1, 1}, {1, 1, 1}}, margin);
  EXPECT_LE(exact(box.lower.x), exact(1) - exact(margin));
  EXPECT_GE(exact(box.upper.x), exact(1) + exact(margin));
}

// An axis that is 2^-47 too short, as axes may be: the coordinate of a point at the distance 1 is greater than 1.
TEST(ProofConstants, AnOrientedBoxGrowsByMoreThanTheMargin) {
  const Mat3 axes{{Vec3{1 - 0x1p-47, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  const Obb grown = offset_outward(Obb{{0, 0, 0}, axes, {0, 0, 0}}, 1);
  EXPECT_GE(exact(grown.half.x) * exact(axes[0].x), exact(1));
}

// Proofs about oriented boxes need axes to be of length 1 up to 2^-46, as the second ones are.
TEST(ProofConstants, AxesThatAreNotOfLengthOneAreRefused) {
  const auto box_along = [](double x) { return Obb{{}, {{Vec3{x, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {1, 1, 1}}; };
  EXPECT_NE(complaint_about(box_along(1 + 0x1p-45)), "");
  EXPECT_EQ(complaint_about(box_along(1 + 0x1p-47)), "");
}

// What is between the centres is rounded up by nearly half a last place, and the sum of the radii down by half a one:
// what is left of a gap of 2^-60 would be a whole one.
TEST(ProofConstants, BallsThatAreHardlyApartMayMeetSoon) {
  const double half = 0x1p-53, gap = 0x1p-60;
  const SpaceTimeBall a{{{-half - gap, 0, 0}, 1}, {.velocity = {1, 0, 0}}}, b{{{1, 0, 0}, half}, {}};
  EXPECT_LE(earliest_contact(a, b), gap);
}

// The products that tell how fast the two come together are less than any double. They meet after less than 2^310.
TEST(ProofConstants, BallsThatComeTogetherMoreSlowlyThanProductsTellMayMeet) {
  const SpaceTimeBall a{{{0, 0, 0}, 0}, {.velocity = {0x1p-700, 0, 0}}}, b{{{0x1p-390, 0, 0}, 0}, {}};
  EXPECT_LE(earliest_contact(a, b), 0x1p310);
}

// Half of the square of the time is 1, and the root of 2 is rounded up.
TEST(ProofConstants, AnAcceleratedMeetingIsNotToldTooLate) {
  const oracle::Rational time = exact(earliest_contact(1, {1, 0, 0}, {.max_acceleration = 1}, {}));
  EXPECT_LE(time * time, 2);
  EXPECT_GE(time * time, 2 - exact(0x1p-40));
}

// The velocity is at right angles to the direction but for 2^-60, and rounding makes it lead away.
TEST(ProofConstants, WhatComesNearerByLessThanRoundingMayMeet) {
  EXPECT_LE(earliest_contact(1, {3, 7, 0x1p-60}, {.velocity = {7, -3, 1}}, {}), 0x8p60);
}

Aabb interval(double lower, double upper) { return {{lower, 0, 0}, {upper, 1, 1}}; }

// The distance is a fiftieth of a last place more than both errors; it is rounded up, and their sum down, to a whole
// one. The gap closes by a last place in a unit of time, so that the two may meet at a fiftieth of it.
TEST(ProofConstants, BoxesThatAreHardlyFartherApartThanTheirErrorsMayMeetSoon) {
  const double unit = 0x1p-52;
  const SpaceTimeBox a{interval(-1, -0.51 * unit), {.velocity = {unit, 0, 0}, .position_error = 1}};
  const SpaceTimeBox b{interval(1, 2), {.position_error = 0.49 * unit}};
  EXPECT_LE(earliest_contact(a, b), 0.1);
}

// The velocities part the two by 1 and half a last place, rounded up, in a unit of time; their errors bring them
// together by 1 and one and a half, rounded down.
TEST(ProofConstants, BoxesThatPartHardlySlowerThanTheirErrorsMayMeet) {
  const double unit = 0x1p-52;
  const SpaceTimeBox a{interval(-1, 0), {.velocity = {-0.51 * unit, 0, 0}, .velocity_error = 1 + unit}};
  const SpaceTimeBox b{interval(1, 2), {.velocity = {1, 0, 0}, .velocity_error = 0.49 * unit}};
  EXPECT_LT(earliest_contact(a, b), 0x1p60);
}

// A quarter of a last place of 1 is lost when it is added to 1.
TEST(ProofConstants, TheErrorOfAMotionIsRoundedUp) {
  EXPECT_GE(exact(greatest_error({.position_error = 1, .velocity_error = 0x1p-54}, 1)), exact(1) + exact(0x1p-54));
  EXPECT_GE(exact(seen_later({.velocity_error = 1, .max_acceleration = 0x1p-54}, 1).velocity_error),
            exact(1) + exact(0x1p-54));
}

// Three times this velocity is 1 + 2^-53, which rounds to 1, and nothing is left of the place where the box begins.
TEST(ProofConstants, ABoxAroundAHornHoldsAWayThatIsRounded) {
  const double third = 0x1.5555555555556p-2;
  ASSERT_EQ(3 * third, 1);
  const Aabb box = box_until({interval(1, 2), {.velocity = {-third, 0, 0}}}, 3);
  EXPECT_LE(exact(box.lower.x), exact(1) - exact(3) * exact(third));
}

// The way is half a last place of the place itself, which it does not change when it is added.
TEST(ProofConstants, ABoxAroundAHornHoldsAPlaceThatIsRounded) {
  const Aabb box = box_until({interval(1, 2), {.velocity = {0x1p-54, 0, 0}}}, 1);
  EXPECT_GE(exact(box.upper.x), exact(2) + exact(0x1p-54));
}

}  // namespace
}  // namespace toccata
