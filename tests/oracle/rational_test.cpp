#include "oracle/rational.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(OracleRational, BecomesTheNearestDouble) {
  EXPECT_EQ(Rational(1, 3).to_double(), 1.0 / 3);
  EXPECT_EQ(Rational(2, 3).to_double(), 2.0 / 3);  // which is rounded up
  EXPECT_EQ(Rational(-2, 3).to_double(), -2.0 / 3);
  EXPECT_EQ((exact(1) + exact(0x1p-53)).to_double(), 1);  // a tie, to the even one
  EXPECT_EQ((exact(1) + exact(0x1.8p-52)).to_double(), 1 + 0x1p-51);
  EXPECT_EQ((exact(1) + exact(0x1.0001p-53)).to_double(), 1 + 0x1p-52);
  EXPECT_EQ((exact(0x1p-53) + exact(1) + exact(0x1p-300)).to_double(), 1 + 0x1p-52);
  EXPECT_EQ(exact(0x1p-1074).scaled(-1).to_double(), 0);
  EXPECT_EQ((exact(0x1p-1074) * Rational(2, 3)).to_double(), 0x1p-1074);
  EXPECT_EQ((exact(0x1p-1074) * Rational(-1, 3)).to_double(), 0);
  EXPECT_EQ(exact(0x1p-1074).scaled(-5000).to_double(), 0);
  EXPECT_EQ(exact(std::numeric_limits<double>::max()).scaled(1).to_double(), std::numeric_limits<double>::infinity());
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const double x = std::ldexp(random.between(-1, 1), static_cast<int>(random.below(600)) - 300);
    const double y = std::ldexp(random.between(0.5, 1), static_cast<int>(random.below(600)) - 300);
    // The processor rounds quotients, products and sums likewise.
    ASSERT_EQ((exact(x) / exact(y)).to_double(), x / y) << x << " " << y;
    ASSERT_EQ((exact(x) * exact(y)).to_double(), x * y) << x << " " << y;
    ASSERT_EQ((exact(x) + exact(y)).to_double(), x + y) << x << " " << y;
  }
}

TEST(OracleRational, CountsAsGmpDoes) {
  using Gmp = boost::multiprecision::mpq_rational;
  const std::uint64_t seed = 12;
  Random random(seed);
  for (int round = 0; round < 300; ++round) {
    Rational own = 1;
    Gmp gmp = 1;
    for (int step = 0; step < 12; ++step) {
      const double x = std::ldexp(random.between(-1, 1), static_cast<int>(random.below(200)) - 100);
      const double y = random.below(4) == 0 ? std::round(8 * x) : x;
      if (y == 0) continue;
      const Rational own_before = own;
      const Gmp gmp_before = gmp;
      switch (random.below(5)) {
        case 0:
          own = own + exact(y), gmp = gmp + Gmp(y);
          break;
        case 1:
          own = own - exact(y), gmp = gmp - Gmp(y);
          break;
        case 2:
          own = own * exact(y), gmp = gmp * Gmp(y);
          break;
        case 3:
          own = own / exact(y), gmp = gmp / Gmp(y);
          break;
        default:
          own = -own / 3, gmp = -gmp / 3;
      }
      ASSERT_EQ(own.sign(), gmp.sign()) << "seed " << seed << " round " << round;
      ASSERT_EQ(own < own_before, gmp < gmp_before) << "seed " << seed << " round " << round;
      ASSERT_EQ(own == own_before, gmp == gmp_before) << "seed " << seed << " round " << round;
      if (own.sign() != 0) {
        ASSERT_NEAR(own.to_double() / gmp.convert_to<double>(), 1, 1e-15) << "seed " << seed << " round " << round;
      }
      // Each is the value of the other: numerator / denominator · 2^exponent.
      const Gmp fraction(Gmp(own.numerator().str()) / Gmp(own.denominator().str()));
      const long e = own.exponent();
      const Gmp power(boost::multiprecision::mpz_int(1) << static_cast<unsigned>(std::abs(e)));
      ASSERT_EQ(e < 0 ? Gmp(fraction / power) : Gmp(fraction * power), gmp) << "seed " << seed << " round " << round;
    }
  }
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
