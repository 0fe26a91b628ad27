#pragma once

#include <optional>
#include <span>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// x · normal ≥ at_least.
struct MotionPlane {
  Vec3 normal;
  double at_least = 0;
};

/// What a change of height costs beside one of the level parts, when the nearest motion is looked for.
struct MotionCost {
  Vec3 up{};          ///< unit
  double height = 1;  ///< factor of heights, above 0
};

/// The motion nearest to the wanted one that keeps to all planes: the projection on their polyhedron, which lies on at
/// most three of them. Nothing where there is none, or it cannot be told in doubles.
[[nodiscard]] std::optional<Vec3> nearest_motion(const Vec3& wanted, std::span<const MotionPlane> planes,
                                                 const MotionCost& cost = {});

}  // namespace toccata
