#include "math/exact.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "math/extreme_doubles.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

using test::largest;
using test::least;

double random_finite(Random& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random.bits());
    if (std::isfinite(value)) return value;
  }
}

Rational power_of_two(int exponent) {
  return exponent >= 0 ? Rational(Integer(1) << exponent) : Rational(Integer(1), Integer(1) << -exponent);
}

/// The value of a decimal number such as "-12.5e-3", read digit by digit.
Rational decimal(const std::string& text) {
  const std::size_t e = text.find('e');
  std::string digits = text.substr(0, e);
  int exponent = e == std::string::npos ? 0 : std::stoi(text.substr(e + 1));
  const std::size_t dot = digits.find('.');
  if (dot != std::string::npos) {
    exponent -= static_cast<int>(digits.size() - dot - 1);
    digits.erase(dot, 1);
  }
  const bool negative = digits[0] == '-';
  Integer number = 0;
  for (const char c : digits)
    if (c != '-') number = number * 10 + (c - '0');
  const Integer power = boost::multiprecision::pow(Integer(10), static_cast<unsigned>(std::abs(exponent)));
  if (negative) number = -number;
  return exponent >= 0 ? Rational(Integer(number * power)) : Rational(number, power);
}

TEST(Exact, RationalOfADoubleIsItsValue) {
  EXPECT_EQ(to_rational(0.0), 0);
  EXPECT_EQ(to_rational(-0.0), 0);
  EXPECT_EQ(to_rational(-0.75), Rational(-3, 4));
  EXPECT_EQ(to_rational(least), power_of_two(-1074));
  EXPECT_EQ(to_rational(largest), power_of_two(1024) - power_of_two(971));
}

TEST(Exact, EveryDoubleComesBack) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double value = random_finite(random);
    ASSERT_EQ(nearest_double(to_rational(value)), value) << "draw " << i;
  }
  for (const double value : {0.0, least, -least, 2 * least, largest, -largest, 0x1p-1022, 0x1.fffffffffffffp-1023})
    EXPECT_EQ(nearest_double(to_rational(value)), value);
}

// Between two neighbours: their middle goes to the even one, and 2^-1200 to either side of it to the nearer one.
TEST(Exact, MiddleGoesToEvenAndAHairBesideItToTheNearer) {
  Random random(2);
  const Rational hair = power_of_two(-1200);
  for (int i = 0; i < 3000; ++i) {
    const double low =
        i < 1000 ? least * static_cast<double>(random.below(1u << 20)) : std::fabs(random_finite(random));
    const double high = std::nextafter(low, HUGE_VAL);
    if (!std::isfinite(high)) continue;
    const Rational middle = (to_rational(low) + to_rational(high)) / 2;
    const double even = (std::bit_cast<std::uint64_t>(low) & 1) == 0 ? low : high;
    ASSERT_EQ(nearest_double(middle), even) << low;
    ASSERT_EQ(nearest_double(middle - hair), low);
    ASSERT_EQ(nearest_double(middle + hair), high);
    ASSERT_EQ(nearest_double(-middle - hair), -high);
  }
}

TEST(Exact, OverflowsToInfinityFromHalfAUnitBeyondTheLargest) {
  const Rational limit = power_of_two(1024) - power_of_two(970);
  EXPECT_EQ(nearest_double(limit - 1), largest);
  EXPECT_EQ(nearest_double(limit), HUGE_VAL);
  EXPECT_EQ(nearest_double(-limit), -HUGE_VAL);
  EXPECT_EQ(nearest_double(power_of_two(5000)), HUGE_VAL);
}

TEST(Exact, UnderflowsToZeroUpToHalfTheLeast) {
  const Rational half = power_of_two(-1075);
  EXPECT_EQ(nearest_double(half), 0);
  EXPECT_FALSE(std::signbit(nearest_double(-half)));
  EXPECT_EQ(nearest_double(half + power_of_two(-2000)), least);
  EXPECT_EQ(nearest_double(-half - power_of_two(-2000)), -least);
  EXPECT_EQ(nearest_double(power_of_two(-9000)), 0);
}

TEST(Exact, AgreesWithStrtodOnDecimals) {
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    std::string text = random.below(2) == 0 ? "-" : "";
    text += std::to_string(random.bits());
    text += "." + std::to_string(random.bits());
    text += "e" + std::to_string(static_cast<int>(random.below(640)) - 340);
    ASSERT_EQ(nearest_double(decimal(text)), std::strtod(text.c_str(), nullptr)) << text;
  }
  for (const char* text : {"1.7976931348623158e308", "1.7976931348623159e308", "2.4703282292062327e-324",
                           "2.4703282292062328e-324", "2.2250738585072011e-308", "9007199254740993", "0.1", "1e-400"})
    EXPECT_EQ(nearest_double(decimal(text)), std::strtod(text, nullptr)) << text;
}

RationalPoint random_point(Random& random) {
  const auto number = [&] {
    const auto numerator = static_cast<std::int64_t>(random.below(7)) - 3;
    return Rational(numerator, static_cast<std::int64_t>(1 + random.below(3)));
  };
  return {number(), number(), number()};
}

TEST(Exact, OrientationOfRationalPointsIsTheSignOfTheDeterminant) {
  Random random(4);
  int zeros = 0;
  for (int i = 0; i < 2000; ++i) {
    const RationalPoint a = random_point(random), b = random_point(random), c = random_point(random),
                        d = random_point(random);
    const Rational volume = dot(cross(b - a, c - a), d - a);
    ASSERT_EQ(orient3d(a, b, c, d), sign_of(volume)) << "draw " << i;
    ASSERT_EQ(orient3d(b, a, c, d), -sign_of(volume)) << "draw " << i;
    zeros += volume == 0;
    const auto area = sign_of(cross(b - a, c - a).z);
    ASSERT_EQ(orient2d(drop_axis(a, 2), drop_axis(b, 2), drop_axis(c, 2)), area) << "draw " << i;
  }
  EXPECT_GT(zeros, 20);
}

}  // namespace
}  // namespace toccata
