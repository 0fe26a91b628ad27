#pragma once

#include <vector>

#include "toccata/bounds/aabb.hpp"

namespace toccata {

/// All eight; bit i of a corner's number says whether coordinate i is the upper one.
[[nodiscard]] inline std::vector<Vec3> corners_of(const Aabb& box) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({(i & 1) != 0 ? box.upper.x : box.lower.x, (i & 2) != 0 ? box.upper.y : box.lower.y,
                       (i & 4) != 0 ? box.upper.z : box.lower.z});
  return corners;
}

}  // namespace toccata
