#include "toccata/math/trigonometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "toccata/core/random.hpp"

namespace toccata {
namespace {

TEST(Trigonometry, QuartersAndTwelfthsAreExact) {
  const double sines[] = {0, 0.5, 1, 0.5, 0, -0.5, -1, -0.5};
  const double degrees[] = {0, 30, 90, 150, 180, 210, 270, 330};
  for (int turn = -2; turn <= 2; ++turn)
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(sine_cosine_of_degrees(degrees[i] + 360 * turn).sine, sines[i]) << degrees[i];
      EXPECT_EQ(sine_cosine_of_degrees(90 - degrees[i] + 360 * turn).cosine, sines[i]) << degrees[i];
    }
  EXPECT_EQ(sine_cosine_of_turns(0.25).sine, 1);
  EXPECT_EQ(sine_cosine_of_turns(0.25).cosine, 0);
  EXPECT_EQ(sine_cosine_of_turns(-0.5).cosine, -1);
}

/// Units in the last place of the exact value by which `value` is off.
double error_in_ulps(double value, long double exact) {
  const double nearest = static_cast<double>(exact);
  const double ulp = std::nextafter(std::abs(nearest), INFINITY) - std::abs(nearest);
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact)) / ulp;
}

TEST(Trigonometry, OffByLessThanTwoUnitsInTheLastPlace) {
  const long double pi = 3.141592653589793238462643383279502884L;
  Random random(1);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    // The long double reference is good to 2⁻⁶⁴ of an argument below π/4.
    const double turns = random.between(-0.125, 0.125);
    const SineCosine result = sine_cosine_of_turns(turns);
    worst = std::max(worst, error_in_ulps(result.sine, std::sin(2 * pi * turns)));
    worst = std::max(worst, error_in_ulps(result.cosine, std::cos(2 * pi * turns)));
    const double degrees = random.between(-45, 45);
    worst = std::max(worst, error_in_ulps(sine_cosine_of_degrees(degrees).sine, std::sin(pi * degrees / 180)));
  }
  EXPECT_LT(worst, 2);
}

TEST(Trigonometry, PeriodicAndOfUnitLength) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double turns = std::ldexp(std::floor(random.between(0, 1 << 20)), -20);
    const SineCosine here = sine_cosine_of_turns(turns), later = sine_cosine_of_turns(turns + 3);
    EXPECT_EQ(here.sine, later.sine);
    EXPECT_EQ(here.cosine, later.cosine);
    EXPECT_NEAR(here.sine * here.sine + here.cosine * here.cosine, 1, 1e-15);
    EXPECT_NEAR(here.sine, std::sin(6.283185307179586 * turns), 1e-15);
    EXPECT_NEAR(here.cosine, std::cos(6.283185307179586 * turns), 1e-15);
  }
}

// Golden bits: any platform that differs is wrong.
TEST(Trigonometry, SameBitsEverywhere) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&](double value) {
    std::uint64_t bits = 0;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    hash = (hash ^ bits) * 1099511628211ULL;
  };
  for (int i = 0; i < 1000; ++i) {
    const SineCosine result = sine_cosine_of_turns(i / 1000.0);
    add(result.sine);
    add(result.cosine);
  }
  EXPECT_EQ(hash, 12788334029006809112U);
}

}  // namespace
}  // namespace toccata
