#pragma once

#include <array>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// The directions from the middle of a cube to its corners and to the middles of its edges and sides, and zero between
/// them: −1, 0 or 1 in each coordinate, x first.
inline constexpr std::array<Vec3, 27> cube_directions = [] {
  std::array<Vec3, 27> directions{};
  auto* direction = directions.data();
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        *direction++ = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  return directions;
}();

}  // namespace toccata
