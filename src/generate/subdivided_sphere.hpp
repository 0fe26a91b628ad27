#pragma once

#include <array>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// Directions spread over the unit sphere and triangles between them that turn outward.
struct SubdividedSphere {
  std::vector<Vec3> directions;
  std::vector<std::array<Index, 3>> triangles;
};

/// The icosahedron with every triangle cut into four, `times` (0 … 8) times: 20 · 4^times triangles.
[[nodiscard]] SubdividedSphere subdivided_sphere(int times);

}  // namespace toccata
