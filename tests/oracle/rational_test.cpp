#include "oracle/rational.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "toccata/core/random.hpp"

namespace toccata::oracle {
namespace {

TEST(OracleRational, DoublesKeepTheirValue) {
  EXPECT_EQ(exact(0.75), Rational(3, 4));
  EXPECT_EQ(exact(-3.0), Rational(-3));
  EXPECT_EQ(exact(-0.0), Rational(0));
  EXPECT_NE(exact(0.1), Rational(1, 10));
  for (const double value : {5e-324, -2.5e-310, 1e-300, 0.1, 1e300, std::numeric_limits<double>::max()})
    EXPECT_EQ(exact(value).to_double(), value) << value;
}

TEST(OracleRational, WorldVertexIsTheLibrarysBitForBit) {
  const std::uint64_t seed = 11;
  Random random(seed);
  for (int round = 0; round < 1000; ++round) {
    std::array<double, 12> numbers{};
    for (double& number : numbers) number = random.between(-3, 3);
    const Pose pose = Pose::from_numbers(numbers);
    const Vec3 local{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    ASSERT_EQ(world_vertex(pose, local), transform(pose, local)) << "seed " << seed << " round " << round;
  }
}

TEST(OracleRational, WorldVertexRoundsAfterEveryStep) {
  Pose pose;
  pose.linear[0] = {1, 1, 1};
  // 2^53 + 1 rounds to 2^53 before the last summand comes.
  EXPECT_EQ(world_vertex(pose, {0x1p53, 1, -0x1p53}).x, 0);
}

TEST(OracleRational, SingularityIsExact) {
  Pose pose;
  EXPECT_FALSE(is_singular(pose));
  pose.linear[2] = {1e-300, 0, 0};
  EXPECT_TRUE(is_singular(pose));
  pose.linear[2] = {0, 0, 5e-324};
  EXPECT_FALSE(is_singular(pose));
}

TEST(OracleRational, RotationsKeepBallsRound) {
  Pose pose;
  pose.linear[0] = {0.6, -0.8, 0};
  pose.linear[1] = {0.8, 0.6, 0};
  EXPECT_TRUE(keeps_balls_round(pose));
  pose.linear[2] = {0, 0, 1 + 0x1p-40};
  EXPECT_FALSE(keeps_balls_round(pose));
  pose.linear[2] = {0, 0, -1};
  EXPECT_TRUE(keeps_balls_round(pose));
}

TEST(OracleRational, ClippingKeepsWhatLiesInThePlane) {
  const std::vector<RationalPoint> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  EXPECT_EQ(clipped(square, half_space({1, 0, 0}, {1, 0, 0})).size(), 4U);
  EXPECT_EQ(clipped(square, half_space({0, 0, 0}, {1, 0, 0})).size(), 2U);
  EXPECT_EQ(clipped(square, half_space({0, 0, 0}, {1, 1, 0})).size(), 1U);
  EXPECT_TRUE(clipped(square, half_space({-1, 0, 0}, {1, 0, 0})).empty());
}

}  // namespace
}  // namespace toccata::oracle
