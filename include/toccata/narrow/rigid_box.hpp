#pragma once

#include <limits>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/box.hpp"

namespace toccata {

/// A box at its place, seen as centre ± half_extents[i] · column i of the pose's linear part, the formula of a box
/// under a pose that hardly deforms. Together with that linear part it is what the formulas for two boxes read.
struct RigidBox {
  Vec3 centre;  ///< in the world
  Vec3 half_extents;
  /// No world corner is farther than this from where the formula has it; infinite where nothing may be concluded from
  /// the formula: the shape is no box, the pose deforms it, or its numbers are beyond 2^1000.
  double slack = std::numeric_limits<double>::infinity();
  double skew = 0;  ///< at least every |RᵀR − I|
};

/// Without slack where the pose has a number that is not finite.
[[nodiscard]] RigidBox rigid_box(const Box& box, const Pose& pose);

}  // namespace toccata
