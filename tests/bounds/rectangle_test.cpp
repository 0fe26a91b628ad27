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

}  // namespace
}  // namespace toccata
