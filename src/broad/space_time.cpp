#include "toccata/broad/space_time.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"

// Rounding. A sum, product, quotient or root is off by one unit u = 2⁻⁵³ of itself, and sums underflow without an
// error. Gaps are taken smaller, and what closes them larger, by some u of the numbers that they are made of.
namespace toccata {
namespace {

/// What is no larger is not told from 0: products of it may underflow.
constexpr double tiny = 0x1p-400;

void require_motion(const SpaceTimeMotion& motion) {
  const auto require = [](double value, double least, const char* name) {
    if (!(value >= least && value <= greatest_double))
      throw Error(fmt::format("the {} of a bound in space and time is {}; it has to be finite{}", name, value,
                              least == 0 ? " and 0 or more" : ""));
  };
  for (int axis = 0; axis < 3; ++axis) require(motion.velocity[axis], -greatest_double, "velocity");
  require(motion.position_error, 0, "position_error");
  require(motion.velocity_error, 0, "velocity_error");
  require(motion.max_acceleration, 0, "max_acceleration");
}

/// What a rate makes of a time, which may be infinite.
double in_time(double time, double rate) { return rate == 0 ? 0 : time * rate; }

/// A gap that closes: it is at least gap − closing · t − acceleration · t² / 2 at every time t from 0.
struct ClosingGap {
  double gap = 0;
  double closing = 0;       ///< negative where the gap opens
  double acceleration = 0;  ///< not negative

  /// A time before which the gap is positive: the root of the parabola, rounded down. With positive closing it is
  /// 2 gap / (closing + root), else (root − closing) / acceleration, so that nothing cancels. In all either is off by
  /// 6 u. Both are smaller by 10 u or more, since the gap was taken smaller by 20 u and the closing larger by 14 u:
  /// with r = root and c = |closing|, a relative change of the gap changes the former by half of it or more, and the
  /// latter by (1 − c/r) / 2 of it, and one of the closing changes the latter by c/r of it.
  [[nodiscard]] double open_until() const {
    if (!(gap > tiny)) return 0;
    if (gap == infinity) return infinity;
    if (acceleration == 0) return closing <= 0 ? infinity : std::min(gap / closing, greatest_double);
    const double discriminant = closing * closing + 2 * acceleration * gap;
    if (!(discriminant > tiny && discriminant < infinity)) return 0;
    const double root = std::sqrt(discriminant);
    if (closing > 0) return std::min(2 * (gap / (closing + root)), greatest_double);
    return std::min((root - closing) / acceleration, greatest_double);
  }
};

/// What closes the gap, besides both velocities, rounded up. `approach`: how fast these bring the two together, off by
/// no more than `unsure`.
ClosingGap closing_gap(double gap, double approach, double unsure, const SpaceTimeMotion& a, const SpaceTimeMotion& b) {
  const double errors = a.velocity_error + b.velocity_error;
  return {gap, approach + errors + (unsure + 0x1p-49 * (std::fabs(approach) + errors)),
          a.max_acceleration + b.max_acceleration};
}

/// Along an axis, the lower one first.
double apart_until(double upper_a, double lower_b, int axis, const SpaceTimeMotion& a, const SpaceTimeMotion& b) {
  double distance = lower_b - upper_a;
  if (!(distance > 0)) return 0;
  if (lower_b < infinity && upper_a > -infinity) distance = std::min(distance, greatest_double);
  // Both errors together are less than the distance, or there is no gap: so 4 u of it cover these roundings.
  const double gap = distance * (1 - 0x1p-48) - (a.position_error + b.position_error);
  return closing_gap(gap, a.velocity[axis] - b.velocity[axis], 0, a, b).open_until();
}

/// The gap between two balls at a later time, as it closes from there: for a unit vector n from one centre to the other
/// |D + V s| ≥ n · D + s n · V, where the centres are D apart then. D and its length are off by 8 u of what is summed
/// up for it, what is subtracted by 4 u of it, and n · V by 12 u of |V|, which includes that V is rounded.
ClosingGap gap_at(double time, const SpaceTimeBall& a, const SpaceTimeBall& b) {
  const Vec3 apart = b.ball.centre - a.ball.centre, velocity = b.motion.velocity - a.motion.velocity;
  const Vec3 now = apart + time * velocity;
  const double speed = sum_of_magnitudes(velocity);
  const double distance = length(now), size = sum_of_magnitudes(apart) + time * speed;
  if (!(size < 0x1p1000)) return {};
  const double radii = a.ball.radius + b.ball.radius;
  const SpaceTimeMotion later_a = seen_later(a.motion, time), later_b = seen_later(b.motion, time);
  const double errors = greatest_error(a.motion, time) + greatest_error(b.motion, time);
  const double gap = distance - ((radii + errors) + 0x1p-48 * size);
  const double approach = distance > 0 ? -dot(now, velocity) / distance : 0;
  return closing_gap(gap, approach, speed > 0 ? 0x1p-48 * speed + 0x1p-600 : 0, later_a, later_b);
}

}  // namespace

double greatest_error(const SpaceTimeMotion& motion, double time) {
  // Four roundings; what underflows is no more than the smallest doubles.
  return (motion.position_error + in_time(time, motion.velocity_error + 0.5 * in_time(time, motion.max_acceleration))) *
             (1 + 0x1p-50) +
         0x1p-1000;
}

SpaceTimeMotion seen_later(const SpaceTimeMotion& motion, double time) {
  return {motion.velocity, 2 * greatest_error(motion, time),
          (motion.velocity_error + in_time(time, motion.max_acceleration)) * (1 + 0x1p-51), motion.max_acceleration};
}

double earliest_contact(double gap, const Vec3& direction, const SpaceTimeMotion& a, const SpaceTimeMotion& b) {
  require_motion(a);
  require_motion(b);
  if (!(gap >= 0 && gap <= greatest_double && is_finite(direction)))
    throw Error(
        fmt::format("a gap in space and time is {}: it has to be finite and 0 or more, and its direction finite", gap));
  const Vec3 velocity = a.velocity - b.velocity, along = unit_or_zero(direction);
  const double speed = sum_of_magnitudes(velocity);
  if (!(speed < 0x1p500)) return 0;
  const double left = gap * (1 - 0x1p-48) - (a.position_error + b.position_error);
  // The direction is off by 8 u of itself, the dot product by 4 u of |V|.
  return closing_gap(left, dot(along, velocity), speed > 0 ? 0x1p-48 * speed + 0x1p-500 : 0, a, b).open_until();
}

double earliest_contact(const SpaceTimeBox& a, const SpaceTimeBox& b) {
  require_motion(a.motion);
  require_motion(b.motion);
  double time = 0;
  for (int axis = 0; axis < 3; ++axis) {
    time = std::max(time, apart_until(a.box.upper[axis], b.box.lower[axis], axis, a.motion, b.motion));
    time = std::max(time, apart_until(b.box.upper[axis], a.box.lower[axis], axis, b.motion, a.motion));
  }
  return time;
}

double earliest_contact(const SpaceTimeBall& a, const SpaceTimeBall& b) {
  require_motion(a.motion);
  require_motion(b.motion);
  if (is_empty(a.ball) || is_empty(b.ball)) return infinity;
  constexpr int most_steps = 64;
  double time = 0;
  // Each step goes to where a plane between the two could be reached, and looks from there: no step passes the root.
  for (int i = 0; i < most_steps; ++i) {
    const double step = gap_at(time, a, b).open_until();
    if (step == infinity) return infinity;
    if (!(step > 0x1p-32 * time)) break;
    time = std::min(std::nextafter(time + step, 0.0), greatest_double);
  }
  return time;
}

Aabb box_until(const SpaceTimeBox& body, double until) {
  require_motion(body.motion);
  if (!(until >= 0))
    throw Error(fmt::format("a time until which a body is to be held is {}; it has to be 0 or more", until));
  if (is_empty(body.box)) return body.box;
  const double error = greatest_error(body.motion, until);
  Aabb around;
  for (int axis = 0; axis < 3; ++axis) {
    const double way = in_time(until, body.motion.velocity[axis]), by = error + 0x1p-50 * std::fabs(way);
    around.lower[axis] = std::nextafter(body.box.lower[axis] + (std::min(way, 0.0) - by), -infinity);
    around.upper[axis] = std::nextafter(body.box.upper[axis] + (std::max(way, 0.0) + by), infinity);
  }
  return around;
}

}  // namespace toccata
