#pragma once

#include <span>

#include "toccata/bounds/aabb.hpp"
#include "toccata/bounds/ball.hpp"

// Where a body can be from now on, and when two can meet at the earliest: bounds in space and time (P. M. Hubbard,
// "Collision detection for interactive graphics applications", 1995). Time counts from now, in a unit of the caller's
// choice; lengths are in world units.
namespace toccata {

/// How the points of a body move: each is, at every time t from 0, no farther from where it was at 0 and the velocity
/// takes it than position_error + velocity_error · t + max_acceleration · t² / 2. With errors of 0 that is Hubbard's
/// parabolic horn. For a body of which only the speed is known, the velocity is 0 and the error is that speed. All
/// numbers are finite; the errors and the acceleration are not negative.
struct SpaceTimeMotion {
  Vec3 velocity{};
  double position_error = 0;
  double velocity_error = 0;
  double max_acceleration = 0;
};

/// How far points may be from where the velocity takes them, rounded up.
[[nodiscard]] double greatest_error(const SpaceTimeMotion& motion, double time);

/// The same motion for who starts the clock `time` later and sees the body then: of its points as they are at that
/// time.
[[nodiscard]] SpaceTimeMotion seen_later(const SpaceTimeMotion& motion, double time);

/// A body within a ball, whose horn has round sections.
struct SpaceTimeBall {
  Ball ball;  ///< contains it at time 0
  SpaceTimeMotion motion{};
};

/// A body within a box, whose horn has boxes as sections.
struct SpaceTimeBox {
  Aabb box;  ///< contains it at time 0; may be infinite
  SpaceTimeMotion motion{};
};

/// A time before which two bodies do not meet that a gap parts now, proved: along the direction, from the first to the
/// second and of any length but 0, all of the second is farther by `gap` than all of the first. +∞ where the gap never
/// closes. Throws Error as below, and when the gap or the direction is not finite, or the gap negative.
[[nodiscard]] double earliest_contact(double gap, const Vec3& direction, const SpaceTimeMotion& a,
                                      const SpaceTimeMotion& b);

/// A time before which the two have no point in common, proved: at most the time at which their horns first touch, 0
/// where they touch now, and +∞ where it is proved that they never do. For balls it is searched for in at most 64
/// steps, and is mostly that time but for 2⁻³⁰ of it; where the horns barely graze or pass each other it may be
/// earlier. For boxes it is the latest time at which along some axis their horns first touch, which may be earlier too.
/// Throws Error naming a number that is not finite, or negative and an error.
[[nodiscard]] double earliest_contact(const SpaceTimeBall& a, const SpaceTimeBall& b);
[[nodiscard]] double earliest_contact(const SpaceTimeBox& a, const SpaceTimeBox& b);

/// Contains the body at all times from 0 to `until`, which may be infinite: the box around the part of its horn,
/// rounded outward. Throws Error for a motion as above, and when `until` is negative or no number.
[[nodiscard]] Aabb box_until(const SpaceTimeBox& body, double until);

}  // namespace toccata
