#include "math/double_word.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/rational.hpp"
#include "toccata/core/random.hpp"

namespace toccata::test {
namespace {

using oracle::Rational;

Rational exact(const DoubleWord& a) { return oracle::exact(a.high) + oracle::exact(a.low); }

/// A random number of any exponent within 30 of 0, and often with a low part much smaller than it might be.
DoubleWord random_word(Random& random) {
  const auto number = [&](int least, std::uint64_t exponents) {
    const int exponent = least + static_cast<int>(random.below(exponents));
    return std::ldexp(random.between(-1, 1), exponent);
  };
  const double high = number(-30, 60);
  return double_word(two_sum(high, high * number(-80, 27)));
}

void expect_near(const DoubleWord& rounded, const Rational& truth) {
  EXPECT_EQ(rounded.high + rounded.low, rounded.high);
  EXPECT_LE(abs(exact(rounded) - truth), oracle::exact(double_word_bound) * abs(truth));
}

TEST(DoubleWord, EveryOperationIsWithinItsBound) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const DoubleWord a = random_word(random);
    DoubleWord b = random_word(random);
    if (random.below(4) == 0) b = double_word(two_sum(-a.high, b.high * 0x1p-100));  // all but cancels
    expect_near(a + b, exact(a) + exact(b));
    expect_near(a - b, exact(a) - exact(b));
    expect_near(a * b, exact(a) * exact(b));
    expect_near(a * b.high, exact(a) * oracle::exact(b.high));
    if (b.high != 0) expect_near(a / b, exact(a) / exact(b));
    ASSERT_FALSE(testing::Test::HasFailure()) << "case " << i;
  }
}

TEST(DoubleWord, DifferencesOfDoublesAreExact) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const double a = random_word(random).high, b = random_word(random).high;
    ASSERT_EQ(exact(exact_difference(a, b)), oracle::exact(a) - oracle::exact(b)) << "case " << i;
  }
}

}  // namespace
}  // namespace toccata::test
