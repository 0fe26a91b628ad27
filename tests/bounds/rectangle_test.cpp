#include "toccata/bounds/swept_sphere.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/rational.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

TEST(Rectangle, TheLecturesQuiz) {
  const Rectangle a{0, 0, 2, 1};
  EXPECT_TRUE(overlap(a, {1, 0.5, 5, 5}));
  EXPECT_TRUE(overlap(a, {2, 1, 1, 1}));  // corner to corner
  EXPECT_FALSE(overlap(a, {3, 0, 1, 1}));
  EXPECT_FALSE(overlap(a, {0, 2, 1, 1}));
  EXPECT_TRUE(overlap(a, {0.5, 0.25, 0, 0}));  // a point within
}

TEST(Rectangle, TheFarCornerIsNotRounded) {
  // 1 − 2^-55 rounds to 1, which would touch the second.
  EXPECT_TRUE(overlap(Rectangle{0, 0, 1, 1}, {1, 0, 1, 1}));
  EXPECT_FALSE(overlap(Rectangle{-0x1p-55, 0, 1, 1}, {1, 0, 1, 1}));
  EXPECT_TRUE(overlap(Rectangle{0x1p-55, 0, 1, 1}, {1, 0, 1, 1}));
}

bool overlap_by_oracle(const Rectangle& a, const Rectangle& b) {
  using oracle::exact;
  return exact(a.x) + exact(a.width) >= exact(b.x) && exact(b.x) + exact(b.width) >= exact(a.x) &&
         exact(a.y) + exact(a.height) >= exact(b.y) && exact(b.y) + exact(b.height) >= exact(a.y);
}

TEST(Rectangle, AgreesWithTheOracle) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto coordinate = [&] {
      const double coarse = static_cast<double>(random.below(5)) - 2;
      return random.below(3) == 0 ? coarse + std::ldexp(random.between(-1, 1), -50) : coarse;
    };
    const auto rectangle = [&] {
      const double x = coordinate(), y = coordinate();
      const double width = std::fabs(coordinate()), height = std::fabs(coordinate());
      return Rectangle{x, y, width, height};
    };
    const Rectangle a = rectangle(), b = rectangle();
    EXPECT_EQ(overlap(a, b), overlap_by_oracle(a, b));
    EXPECT_EQ(overlap(b, a), overlap(a, b));
  }
}

/// Boxes by their upper left corners, with y upwards: the rows of each go from y − height to y.
bool overlap_by_upper_left_corners(const Rectangle& a, const Rectangle& b) {
  using oracle::exact;
  return exact(a.x) <= exact(b.x) + exact(b.width) && exact(b.x) <= exact(a.x) + exact(a.width) &&
         exact(a.y) - exact(a.height) <= exact(b.y) && exact(b.y) - exact(b.height) <= exact(a.y);
}

/// The same rows seen from above: −y is exact, and the upper left corner is the one of least coordinates.
Rectangle of_upper_left(double x, double y, double width, double height) { return {x, -y, width, height}; }

TEST(Rectangle, OfUpperLeftCornersIsTheQuizWithYTurnedRound) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto number = [&] {
      const double coarse = static_cast<double>(random.below(5)) - 2;
      return random.below(3) == 0 ? coarse + std::ldexp(random.between(-1, 1), -50) : coarse;
    };
    const auto rectangle = [&] {
      const double x = number(), y = number(), width = std::fabs(number()), height = std::fabs(number());
      return Rectangle{x, y, width, height};
    };
    const Rectangle a = rectangle(), b = rectangle();
    EXPECT_EQ(overlap(of_upper_left(a.x, a.y, a.width, a.height), of_upper_left(b.x, b.y, b.width, b.height)),
              overlap_by_upper_left_corners(a, b));
  }
  // Which way y points has to be said: the same eight numbers, with y down and with y up.
  EXPECT_FALSE(overlap(Rectangle{0, 0, 1, 1}, Rectangle{0, 2, 1, 2}));
  EXPECT_TRUE(overlap(of_upper_left(0, 0, 1, 1), of_upper_left(0, 2, 1, 2)));
}

}  // namespace
}  // namespace toccata
