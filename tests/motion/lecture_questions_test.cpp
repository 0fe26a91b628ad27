// The questions of the lectures about what happens between two steps, each shown (docs/methods/questions.md lists
// them).
#include <gtest/gtest.h>

#include <cmath>

#include "toccata/motion/rigid_motion.hpp"
#include "toccata/motion/swept_volume.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata {
namespace {

/// Straight along x, from a place on.
struct Flight {
  Model body;
  Vec3 from;
  Vec3 way;
  [[nodiscard]] Pose at(double time) const { return Pose::translation(from + time * way); }
  [[nodiscard]] RigidMotion between(double begin, double end) const {
    return RigidMotion::straight(at(begin), (end - begin) * way);
  }
};

/// Overlap testing: whether two are found to overlap at one of the steps 0, 1/n … 1.
bool overlap_at_a_step(const Flight& a, const Flight& b, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double time = static_cast<double>(i) / steps;
    if (overlap(a.body, b.body, {.pose_a = a.at(time), .pose_b = b.at(time)})) return true;
  }
  return false;
}

std::optional<ShapeHit> first_meeting(const Flight& a, const Flight& b) {
  return sweep(a.body, a.between(0, 1), b.body, b.between(0, 1));
}

const Flight wall{Box({0.0625, 4, 4}), {}, {}};

TEST(LectureQuestion, OverlapTestingMissesWhatIntersectionTestingFinds) {
  // A fast ball is before the wall at one step and behind it at the next.
  const Flight fast{Sphere(0.125), {-8.5, 0, 0}, {16, 0, 0}};
  EXPECT_FALSE(overlap_at_a_step(fast, wall, 16));
  const std::optional<ShapeHit> hit = first_meeting(fast, wall);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->upper, (8.5 - 0.125 - 0.0625) / 16, 1e-12);
}

TEST(LectureQuestion, OverlapTestingFindsTheTimeByBisectingBack) {
  // A slow one is found, deep in the wall, and the time of contact by halving the last step until it is narrow enough.
  const Flight slow{Sphere(0.5), {-3, 0.25, 0}, {3, 0, 0}};
  ASSERT_TRUE(overlap_at_a_step(slow, wall, 4));
  double free = 0, overlapping = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (free + overlapping);
    (overlap(slow.body, wall.body, {.pose_a = slow.at(middle)}) ? overlapping : free) = middle;
  }
  const std::optional<ShapeHit> hit = first_meeting(slow, wall);
  EXPECT_NEAR(hit->lower, overlapping, 1e-11);
  EXPECT_NEAR(hit->upper, free, 1e-11);
}

TEST(LectureQuestion, ANoOfEveryStepIsSureOnlyUpToTheSumOfBothThicknesses) {
  // Head on, ball and wall overlap for 2 · 0.125 + 2 · 0.0625 = 0.375 of the way. Steps of that length always see it,
  // though it is more than either is thick; steps a little longer may not.
  for (int offset = 0; offset <= 64; ++offset) {
    const double start = -6 + offset / 64.0 * 0.375;
    EXPECT_TRUE(overlap_at_a_step({Sphere(0.125), {start, 0, 0}, {32 * 0.375, 0, 0}}, wall, 32));
  }
  EXPECT_FALSE(overlap_at_a_step({Sphere(0.125), {-0.1953125, 0, 0}, {0.390625, 0, 0}}, wall, 1));
  // What only grazes overlaps for as short a way as one likes, so that no step is short enough.
  const Flight resting{Sphere(1), {}, {}};
  const Flight grazing{Sphere(1), {-2.0078125, 1.9999999, 0}, {4, 0, 0}};
  EXPECT_FALSE(overlap_at_a_step(grazing, resting, 64));  // steps of a thirtieth of either
  EXPECT_TRUE(first_meeting(grazing, resting));
}

TEST(LectureQuestion, SweptVolumesMeetWhereTwoPassAtDifferentTimes) {
  const Flight ball{Sphere(0.5), {-4, 0, 0}, {8, 0, 0}};
  const auto crossing = [](double start) { return Flight{Box({0.5, 0.5, 0.5}), {0, start, 0}, {0, 8, 0}}; };
  const auto meeting = [&](const Flight& box) {
    return may_meet(swept_volume(ball.body, ball.between(0, 1)), swept_volume(box.body, box.between(0, 1)));
  };
  // At the crossing together; there a second too late; and on a way that passes by.
  EXPECT_EQ(meeting(crossing(-4)), SweptOverlap::maybe);
  EXPECT_TRUE(first_meeting(ball, crossing(-4)));
  EXPECT_EQ(meeting(crossing(-6)), SweptOverlap::maybe);
  EXPECT_FALSE(first_meeting(ball, crossing(-6)));
  EXPECT_EQ(meeting(crossing(2)), SweptOverlap::never);
}

TEST(LectureQuestion, TwoBallsThatMoveMeetWhereTheirDifferenceEntersTheSumOfTheirRadii) {
  const Flight a{Sphere(1), {-5, 0.5, 0}, {8, 0, 1}}, b{Sphere(0.5), {4, -1, 1}, {-4, 2, 0}};
  // |p + t v| = r, of which the first root is the contact: a ray against the sum of a ball and a ball.
  const Vec3 p = a.from - b.from, v = a.way - b.way;
  const double half = dot(p, v), square = dot(v, v), r = 1.5;
  const double first = (-half - std::sqrt(half * half - square * (dot(p, p) - r * r))) / square;
  const std::optional<ShapeHit> hit = first_meeting(a, b);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->lower, first, 1e-12);
  EXPECT_NEAR(hit->upper, first, 1e-12);
}

/// "Recurse in time": the earlier half first. A stretch whose swept volumes are apart is free; one that is short enough
/// and may meet counts as a meeting.
double first_by_halving(const Flight& a, const Flight& b, double begin, double end, int& stretches) {
  ++stretches;
  const SweptOverlap meeting =
      may_meet(swept_volume(a.body, a.between(begin, end)), swept_volume(b.body, b.between(begin, end)));
  if (meeting == SweptOverlap::never) return 2;
  if (end - begin < 1e-4) return begin;
  const double middle = 0.5 * (begin + end);
  const double earlier = first_by_halving(a, b, begin, middle, stretches);
  return earlier < 2 ? earlier : first_by_halving(a, b, middle, end, stretches);
}

TEST(LectureQuestion, HalvingTheTimeEndsAtTheFirstContactOrProvesThatThereIsNone) {
  const Flight ball{Sphere(0.5), {-4, 0, 0}, {8, 0, 0}};
  const Flight box{Box({0.5, 0.5, 0.5}), {0, -4, 0}, {0, 8, 0}}, late{box.body, {0, -6, 0}, {0, 8, 0}};
  int stretches = 0;
  const double found = first_by_halving(ball, box, 0, 1, stretches);
  const std::optional<ShapeHit> hit = first_meeting(ball, box);
  EXPECT_LE(found, hit->upper);
  EXPECT_GT(found, hit->lower - 1e-3);
  EXPECT_LT(stretches, 200);
  EXPECT_EQ(first_by_halving(ball, late, 0, 1, stretches = 0), 2);
  EXPECT_LT(stretches, 50);  // no stretch had to become short
}

}  // namespace
}  // namespace toccata
