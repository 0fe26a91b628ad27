#pragma once

#include "toccata/motion/rigid_motion.hpp"

namespace toccata {

/// The pose after the part `part` of the move, from 0 to 1; at 0 the one that it started from.
[[nodiscard]] Pose moved(const Pose& start, const RigidMove& move, double part);

/// The shortest turn about an axis that brings `from` to `to`, but for rounding; no turn has no axis. Throws Error
/// where none does, within 2⁻¹⁰ of the greatest number.
struct TurnBetween {
  Vec3 axis{0, 0, 1};
  double turns = 0;  ///< from 0 to 1/2
};
[[nodiscard]] TurnBetween turn_between(const Mat3& from, const Mat3& to);

}  // namespace toccata
