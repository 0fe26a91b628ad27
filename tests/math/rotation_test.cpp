#include "toccata/math/pose.hpp"

#include <gtest/gtest.h>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/trigonometry.hpp"

namespace toccata {
namespace {

TEST(Rotation, QuarterTurnsAreExact) {
  EXPECT_EQ(rotation_about({0, 0, 5}, 90), (Mat3{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}}));
  EXPECT_EQ(rotation_about({1, 0, 0}, 180), (Mat3{{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}}));
  EXPECT_EQ(rotation_about({0, -1, 0}, 90), (Mat3{{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}}));
  EXPECT_EQ(rotation_of({0, 0, 1, 1}), rotation_about({0, 0, 1}, 90));
  EXPECT_EQ(rotation_of({}), Mat3{});
}

TEST(Rotation, KeepsItsAxisAndIsOrthogonal) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec3 axis{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double degrees = random.between(-400, 400);
    const Mat3 m = rotation_about(axis, degrees);
    for (int row = 0; row < 3; ++row) {
      EXPECT_NEAR(dot(m[row], axis), axis[row], 1e-14);
      for (int other = 0; other < 3; ++other) EXPECT_NEAR(dot(m[row], m[other]), row == other ? 1 : 0, 1e-14);
    }
    const auto [s, c] = sine_cosine_of_degrees(degrees / 2);
    const Vec3 v = (s / std::sqrt(dot(axis, axis))) * axis;
    const Mat3 same = rotation_of({v.x, v.y, v.z, c});
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) EXPECT_NEAR(m[row][column], same[row][column], 1e-14);
  }
}

TEST(Rotation, RefusesWhatHasNoDirection) {
  EXPECT_THROW((void)rotation_about({0, 0, 0}, 1), Error);
  EXPECT_THROW((void)rotation_about({0, 0, 1}, INFINITY), Error);
  EXPECT_THROW((void)rotation_of({0, 0, 0, 0}), Error);
}

double deviation(const Mat3& m) {
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      largest = std::fmax(largest, std::fabs(dot(m.column(i), m.column(j)) - (i == j ? 1 : 0)));
  return largest;
}

TEST(Rotation, NearestOfAStretchedRotationIsTheRotation) {
  Random random(7);
  const auto number = [&] { return random.between(-1, 1); };
  for (int i = 0; i < 300; ++i) {
    const Mat3 turn = rotation_about({number(), number(), 2}, 180 * number());
    const Mat3 along = rotation_about({number(), 2, number()}, 180 * number());
    Mat3 stretch;  // symmetric and positive: turn is the polar factor of turn * stretched
    for (int axis = 0; axis < 3; ++axis) stretch[axis][axis] = std::exp2(3 * number());
    const Mat3 stretched = along * stretch * transpose(along);
    const double scale = std::exp2(900 * number());
    Mat3 given = turn * stretched;
    for (Vec3& row : given.row) row *= scale;
    const Mat3 found = nearest_rotation(given);
    EXPECT_LT(deviation(found), 1e-15);
    for (int row = 0; row < 3; ++row) EXPECT_LT(length(found[row] - turn[row]), 1e-13) << i;
  }
}

TEST(Rotation, NearestOfARotationIsNearlyItself) {
  EXPECT_EQ(nearest_rotation({}), Mat3{});
  const Mat3 quarter = rotation_about({0, 1, 0}, 90);
  EXPECT_EQ(nearest_rotation(quarter), quarter);
}

TEST(Rotation, NearestRefusesWhatMirrorsOrFlattens) {
  EXPECT_THROW((void)nearest_rotation({{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}}), Error);
  EXPECT_THROW((void)nearest_rotation({{{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}}}), Error);
  EXPECT_THROW((void)nearest_rotation({{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}}), Error);
  EXPECT_THROW((void)nearest_rotation({{{{1, 0, 0}, {0, NAN, 0}, {0, 0, 1}}}}), Error);
  try {  // nearly flat: an answer is a rotation, or there is none
    EXPECT_LT(deviation(nearest_rotation({{{{1, 0, 0}, {0, 1e-200, 0}, {0, 0, 1e-250}}}})), 1e-15);
  } catch (const Error&) {
  }
}

TEST(Rotation, PoseScalesFirst) {
  const Pose pose = pose_of({10, 0, 0}, rotation_about({0, 0, 1}, 90), {2, 3, 4});
  EXPECT_EQ(transform(pose, {1, 1, 1}), (Vec3{7, 2, 4}));
}

}  // namespace
}  // namespace toccata
