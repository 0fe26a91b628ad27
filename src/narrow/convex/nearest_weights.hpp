#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "toccata/math/vec3.hpp"

namespace toccata {

using SimplexPoints = std::array<Vec3, 4>;
using SimplexWeights = std::array<double, 4>;

inline double clamped_share(double weight) { return weight > 0 ? std::min(weight, 1.0) : 0; }

/// Weights near those of the point of a triangle that is nearest to the origin, if that lies within it.
inline SimplexWeights nearest_weights_in_triangle(const SimplexPoints& p) {
  const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
  const double whole = dot(normal, normal);
  const double second = clamped_share(dot(cross(p[2], p[0]), normal) / whole);
  const double third = std::min(clamped_share(dot(cross(p[0], p[1]), normal) / whole), 1 - second);
  return {(1 - second) - third, second, third, 0};
}

/// The same of a simplex of so many corners, up to three: not negative, and 1 together within 2⁻⁵².
[[nodiscard]] inline SimplexWeights nearest_weights(const SimplexPoints& p, std::size_t size) {
  if (size == 3) return nearest_weights_in_triangle(p);
  if (size != 2) return {1, 0, 0, 0};
  const Vec3 along = p[1] - p[0];
  const double second = clamped_share(-dot(p[0], along) / dot(along, along));
  return {1 - second, second, 0, 0};
}

}  // namespace toccata
