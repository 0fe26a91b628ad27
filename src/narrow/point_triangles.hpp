#pragma once

#include <array>
#include <cstddef>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// Up to eight triangles side by side, in the world. All lanes are computed, so none may be left unwritten.
struct alignas(64) TriangleBlock {
  static constexpr std::size_t lanes = 8;
  std::array<std::array<std::array<double, lanes>, 3>, 3> corner;  ///< by corner and axis
};

/// How far each of them is from a point.
struct alignas(64) PointDistances {
  using Lanes = std::array<double, TriangleBlock::lanes>;
  Lanes lower;                   ///< never above the exact distance
  Lanes upper;                   ///< of `distance` of the point and the triangle; NaN where a formula does not prove it
  std::array<Lanes, 3> nearest;  ///< the point of the triangle that goes with it

  [[nodiscard]] Vec3 point(std::size_t lane) const { return {nearest[0][lane], nearest[1][lane], nearest[2][lane]}; }
};

/// The same bits at every SIMD level, and as `distance` of the point and the triangle as convex shapes.
void measure(const Vec3& point, const TriangleBlock& triangles, PointDistances& distances);

}  // namespace toccata
