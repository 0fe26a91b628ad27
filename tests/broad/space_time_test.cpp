#include "toccata/broad/space_time.hpp"

#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "math/constants.hpp"
#include "oracle/rational.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

Vec3 vector_between(Random& random, double low, double high) {
  const double x = random.between(low, high), y = random.between(low, high), z = random.between(low, high);
  return {x, y, z};
}

/// Some have errors of 0, some no acceleration, and some only errors.
SpaceTimeMotion random_motion(Random& random) {
  const auto often_zero = [&](double most) { return random.below(2) == 0 ? 0 : random.between(0, most); };
  return {random.below(4) == 0 ? Vec3{} : vector_between(random, -1, 1), often_zero(0.25), often_zero(0.25),
          often_zero(0.5)};
}

Rational exact_error(const SpaceTimeMotion& motion, const Rational& time) {
  return exact(motion.position_error) + exact(motion.velocity_error) * time +
         exact(motion.max_acceleration) * time * time * exact(0.5);
}

bool are_apart(const SpaceTimeBall& a, const SpaceTimeBall& b, const Rational& time) {
  const auto apart =
      exact(b.ball.centre) - exact(a.ball.centre) + time * (exact(b.motion.velocity) - exact(a.motion.velocity));
  const Rational reach =
      exact(a.ball.radius) + exact(b.ball.radius) + exact_error(a.motion, time) + exact_error(b.motion, time);
  return oracle::dot(apart, apart) > reach * reach;
}

bool are_apart(const SpaceTimeBox& a, const SpaceTimeBox& b, const Rational& time) {
  const Rational errors = exact_error(a.motion, time) + exact_error(b.motion, time);
  for (int i = 0; i < 3; ++i) {
    const Rational way = time * (exact(b.motion.velocity[i]) - exact(a.motion.velocity[i]));
    if (exact(b.box.lower[i]) + way > exact(a.box.upper[i]) + errors) return true;
    if (exact(a.box.lower[i]) > exact(b.box.upper[i]) + way + errors) return true;
  }
  return false;
}

/// At times up to just before what is told, and far on where they never meet.
template <class Body>
void expect_apart_until(double told, const Body& a, const Body& b) {
  if (told == 0) return;
  const double last = std::min(std::nextafter(told, 0.0), 1e6);
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(are_apart(a, b, exact(last) * exact(i / 8.0))) << i;
  EXPECT_TRUE(are_apart(a, b, exact(last)));
}

TEST(EarliestContact, OfBallsThatAreThrownAtEachOtherIsTheRootOfTheParabola) {
  const SpaceTimeBall a{{{0, 0, 0}, 1}, {.velocity = {1, 0, 0}, .max_acceleration = 2}};
  const SpaceTimeBall b{{{10, 0, 0}, 1}, {.velocity = {-1, 0, 0}, .max_acceleration = 2}};
  const double root = (-2 + std::sqrt(4.0 + 4 * 2 * 8)) / 4;  // 8 - 2 t - 2 t² = 0
  EXPECT_LE(earliest_contact(a, b), root);
  EXPECT_NEAR(earliest_contact(a, b), root, 1e-9);
  EXPECT_EQ(earliest_contact(a, {{{1, 0, 0}, 1}, {}}), 0);
  EXPECT_EQ(earliest_contact(SpaceTimeBall{{{0, 0, 0}, 1}, {}}, {{{3, 0, 0}, 1}, {}}), infinity);
  EXPECT_EQ(earliest_contact(a, SpaceTimeBall{}), infinity) << "an empty ball";
}

/// A gap along a direction closes as all of it comes nearer: in rationals, squared where a length comes in.
TEST(EarliestContact, OfAGapNoneMeetsBeforeInExactArithmetic) {
  Random random(5);
  int finite = 0;
  for (int i = 0; i < 2000; ++i) {
    const SpaceTimeMotion a = random_motion(random), b = random_motion(random);
    const Vec3 direction = vector_between(random, -1, 1);
    const double gap = random.between(0, 4), time = earliest_contact(gap, direction, a, b);
    if (time == 0) continue;
    finite += time < infinity ? 1 : 0;
    const Rational last = exact(std::min(std::nextafter(time, 0.0), 1e6));
    for (int share = 1; share <= 4; ++share) {
      const Rational at = last * exact(share / 4.0);
      const Rational closing = oracle::dot(exact(a.velocity) - exact(b.velocity), exact(direction)) * at;
      const Rational left = exact(gap) - exact_error(a, at) - exact_error(b, at);  // is it more than closing / |d|?
      const Rational lefts = left * left * oracle::dot(exact(direction), exact(direction)), zero(0);
      const bool is_open =
          left > zero ? closing <= zero || lefts > closing * closing : closing < zero && closing * closing > lefts;
      EXPECT_TRUE(is_open) << i;
    }
  }
  EXPECT_GT(finite, 500);
}

TEST(EarliestContact, OfAGapIsThatAlongItsDirection) {
  const SpaceTimeMotion still{}, coming{.velocity = {-2, 5, 0}};
  EXPECT_NEAR(earliest_contact(4, {3, 0, 0}, still, coming), 2, 1e-12);
  EXPECT_EQ(earliest_contact(4, {-3, 0, 0}, still, coming), infinity);
  EXPECT_EQ(earliest_contact(0, {1, 0, 0}, still, coming), 0);
  EXPECT_THROW(static_cast<void>(earliest_contact(-1, {1, 0, 0}, still, coming)), Error);
  EXPECT_THROW(static_cast<void>(earliest_contact(1, {infinity, 0, 0}, still, coming)), Error);
  EXPECT_THROW(static_cast<void>(earliest_contact(1, {1, 0, 0}, still, {.velocity_error = -1})), Error);
}

TEST(EarliestContact, OfABallThatPassesIsNever) {
  const SpaceTimeBall a{{{0, 0, 0}, 1}, {}}, b{{{-10, 2.5, 0}, 1}, {.velocity = {1, 0, 0}}};
  EXPECT_GT(earliest_contact(a, b), 1e6);
  const SpaceTimeBall c{{{-10, 1, 0}, 1}, {.velocity = {1, 0, 0}}};
  EXPECT_NEAR(earliest_contact(a, c), 10 - std::sqrt(3.0), 1e-8);
}

TEST(EarliestContact, OfBallsNoneMeetsBeforeInExactArithmetic) {
  Random random(1);
  int later = 0;
  for (int i = 0; i < 400; ++i) {
    const auto body = [&] {
      const Vec3 centre = vector_between(random, -4, 4);
      return SpaceTimeBall{{centre, random.between(0, 1)}, random_motion(random)};
    };
    const SpaceTimeBall a = body(), b = body();
    const double told = earliest_contact(a, b);
    EXPECT_EQ(told, earliest_contact(b, a));
    expect_apart_until(told, a, b);
    EXPECT_TRUE(told > 0 || !are_apart(a, b, 0));
    // And a little later their horns do meet.
    if (told > 0 && told < 1e6 && !are_apart(a, b, exact(told) * exact(1.001))) ++later;
  }
  EXPECT_GT(later, 200);
}

TEST(EarliestContact, OfBoxesNoneMeetsBeforeInExactArithmetic) {
  Random random(2);
  int never = 0, some_time = 0;
  for (int i = 0; i < 400; ++i) {
    const auto body = [&] {
      const Vec3 centre = vector_between(random, -4, 4), half = vector_between(random, 0, 1);
      return SpaceTimeBox{{centre - half, centre + half}, random_motion(random)};
    };
    const SpaceTimeBox a = body(), b = body();
    const double told = earliest_contact(a, b);
    EXPECT_EQ(told, earliest_contact(b, a));
    expect_apart_until(told, a, b);
    ++(told == infinity ? never : some_time);
  }
  EXPECT_GT(never, 40);
  EXPECT_GT(some_time, 200);
}

TEST(EarliestContact, IsNeverTooLateForHugeAndTinyNumbers) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const double size = std::ldexp(1, static_cast<int>(random.below(1900)) - 1000);
    const auto body = [&] {
      SpaceTimeMotion motion = random_motion(random);
      const double speed = std::ldexp(1, static_cast<int>(random.below(1900)) - 1000);
      motion = {speed * motion.velocity, size * motion.position_error, speed * motion.velocity_error,
                std::ldexp(motion.max_acceleration, static_cast<int>(random.below(1900)) - 1000)};
      return SpaceTimeBall{{size * vector_between(random, -4, 4), size * random.between(0, 1)}, motion};
    };
    const SpaceTimeBall a = body(), b = body();
    expect_apart_until(earliest_contact(a, b), a, b);
    const auto box = [](const SpaceTimeBall& ball) {
      return SpaceTimeBox{{ball.ball.centre, ball.ball.centre + Vec3{ball.ball.radius, 0, 0}}, ball.motion};
    };
    expect_apart_until(earliest_contact(box(a), box(b)), box(a), box(b));
  }
}

TEST(EarliestContact, OfInfiniteAndEmptyBoxes) {
  const SpaceTimeBox unit{{{0, 0, 0}, {1, 1, 1}}, {}};
  const SpaceTimeBox below{{{-infinity, -infinity, -infinity}, {infinity, infinity, -1}}, {.velocity = {0, 0, 0.5}}};
  EXPECT_NEAR(earliest_contact(unit, below), 2, 1e-12);
  EXPECT_EQ(earliest_contact(unit, SpaceTimeBox{}), infinity);
  EXPECT_EQ(earliest_contact(below, {{{-infinity, 0, -2}, {infinity, 1, infinity}}, {}}), 0);
}

TEST(EarliestContact, OfBoxesThatPartAndComeBackIsNotTooLate) {
  const auto interval = [](double lower, double upper) { return Aabb{{lower, 0, 0}, {upper, 1, 1}}; };
  for (const double speed : {1.0, 3.0, 5.0, 11.0})
    for (const double acceleration : {3.0, 5.0, 7.0, 11.0, 13.0}) {
      const SpaceTimeBox a{interval(-1, 0), {.max_acceleration = acceleration}};
      const SpaceTimeBox b{interval(0x1p-80, 2), {.velocity = {speed, 0, 0}}};
      const auto time = exact(earliest_contact(a, b));
      EXPECT_GE(exact(0x1p-80) + exact(speed) * time, exact(acceleration / 2) * time * time);
    }
}

/// Bodies that are driven at random, as wildly as their bounds allow, step by step.
TEST(EarliestContact, HoldsForWhoeverKeepsItsBounds) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    std::array<SpaceTimeBall, 2> bodies;
    for (SpaceTimeBall& body : bodies)
      body = {{vector_between(random, -3, 3), 0.5},
              {.velocity = vector_between(random, -0.1, 0.1), .max_acceleration = random.between(0, 0.02)}};
    const double told = earliest_contact(bodies[0], bodies[1]);
    std::array<Vec3, 2> at{bodies[0].ball.centre, bodies[1].ball.centre};
    std::array<Vec3, 2> velocity{bodies[0].motion.velocity, bodies[1].motion.velocity};
    for (double time = 0; time + 1 < std::min(told, 100.0); time += 1) {
      for (std::size_t b = 0; b < 2; ++b) {
        const Vec3 pull = bodies[b].motion.max_acceleration * normalized(vector_between(random, -1, 1));
        at[b] += velocity[b] + 0.5 * pull;
        velocity[b] += pull;
      }
      EXPECT_GT(length(at[1] - at[0]), 1) << time;
    }
  }
}

TEST(BoxUntil, ContainsTheSectionsOfTheHorn) {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Vec3 centre = vector_between(random, -4, 4), half = vector_between(random, 0, 1);
    const SpaceTimeBox body{{centre - half, centre + half}, random_motion(random)};
    const double until = random.between(0, 8);
    const Aabb around = box_until(body, until);
    for (const double part : {0.0, 0.25, 0.5, 1.0}) {
      const Rational time = exact(until) * exact(part), error = exact_error(body.motion, time);
      for (int axis = 0; axis < 3; ++axis) {
        const Rational way = time * exact(body.motion.velocity[axis]);
        EXPECT_LE(exact(around.lower[axis]), exact(body.box.lower[axis]) + way - error);
        EXPECT_GE(exact(around.upper[axis]), exact(body.box.upper[axis]) + way + error);
      }
    }
  }
}

TEST(SeenLater, HoldsOfPointsAsTheyAreThen) {
  const SpaceTimeMotion motion{{1, 2, 3}, 0.25, 0.5, 0.125};
  const SpaceTimeMotion later = seen_later(motion, 3);
  for (const double time : {0.0, 1.0, 5.0})
    EXPECT_GE(greatest_error(later, time), greatest_error(motion, 3) + greatest_error(motion, 3 + time) - 1e-12);
}

TEST(BoxUntil, HoldsForEverWhatIsAskedForEver) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  const Aabb at_rest = box_until({box, {}}, infinity), moving = box_until({box, {.velocity = {1, 0, 0}}}, infinity);
  EXPECT_TRUE(at_rest.lower.x <= 0 && at_rest.lower.x > -1e-9 && at_rest.upper.x >= 1 && at_rest.upper.x < 1 + 1e-9);
  EXPECT_EQ(moving.upper.x, infinity);
  EXPECT_TRUE(moving.lower.y <= 0 && moving.lower.y > -1e-9 && moving.upper.y >= 1 && moving.upper.y < 1 + 1e-9);
  EXPECT_EQ(box_until({box, {.max_acceleration = 1}}, infinity).upper.z, infinity);
  EXPECT_THROW(static_cast<void>(box_until({box, {}}, -0.5)), Error);
  EXPECT_THROW(static_cast<void>(box_until({box, {}}, std::nan(""))), Error);
}

TEST(EarliestContact, RefusesWhatIsNoBound) {
  const SpaceTimeBox box{{{0, 0, 0}, {1, 1, 1}}, {.max_acceleration = -1}};
  try {
    static_cast<void>(earliest_contact(SpaceTimeBox{}, box));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("max_acceleration"), std::string::npos) << error.what();
  }
  EXPECT_THROW(static_cast<void>(box_until({{}, {.velocity_error = infinity}}, 1)), Error);
  EXPECT_THROW(static_cast<void>(earliest_contact({{}, {.velocity = {0, infinity, 0}}}, SpaceTimeBall{})), Error);
}

}  // namespace
}  // namespace toccata::test
