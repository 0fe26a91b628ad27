#pragma once

#include <array>

#include "math/vec3_measures.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// A box is told from a single item by more than the item's box where it is no more than this part of that: it costs as
/// much as some ten steps of a walk.
inline constexpr float small_beside_item = 0.25F;

/// The normal of a triangle, and the normals of its sides in its plane: of length 1 but for rounding, or zero. What
/// they do not tell from the triangle is a prism that stands on it. Boxes that are small beside a triangle are told
/// from it so much better than from its box.
inline std::array<Vec3, 4> prism_directions(const std::array<Vec3, 3>& corners) {
  const std::array<Vec3, 3> sides{unit_or_zero(corners[1] - corners[0]), unit_or_zero(corners[2] - corners[1]),
                                  unit_or_zero(corners[0] - corners[2])};
  const Vec3 normal = unit_or_zero(cross(sides[0], sides[1]));
  return {normal, unit_or_zero(cross(normal, sides[0])), unit_or_zero(cross(normal, sides[1])),
          unit_or_zero(cross(normal, sides[2]))};
}

}  // namespace toccata
