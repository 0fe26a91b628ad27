#pragma once

#include <array>
#include <cstddef>

#include "toccata/math/pose.hpp"

namespace toccata {

/// Up to eight triangles side by side, in the first lanes. Others may be computed too, so none may be left unwritten;
/// nothing is told of them.
struct alignas(64) TriangleBlock {
  static constexpr std::size_t lanes = 8;
  std::array<std::array<std::array<double, lanes>, 3>, 3> corner{};  ///< by corner and axis
  std::size_t count = 0;
};

/// Numbers between which the distance of each from a point lies: mostly to some 2⁻⁴⁶ of the greatest difference of a
/// corner from the point. 0 and infinity where plain arithmetic leaves its range.
struct alignas(64) PointBounds {
  std::array<double, TriangleBlock::lanes> lower;
  std::array<double, TriangleBlock::lanes> upper;
};

/// Bounds the distances of the point from the triangles at their place in the world, of which `triangles` has the
/// corners in their own frame. The same bits at every SIMD level.
void bound(const Vec3& point, const Pose& pose, const TriangleBlock& triangles, PointBounds& bounds);

/// How far each of them is from a point, proved to what is promised of distances.
struct alignas(64) PointDistances {
  using Lanes = std::array<double, TriangleBlock::lanes>;
  Lanes lower;                   ///< never above the exact distance
  Lanes upper;                   ///< of `distance` of the point and the triangle; NaN where a formula does not prove it
  std::array<Lanes, 3> nearest;  ///< the point of the triangle that goes with it

  [[nodiscard]] Vec3 point(std::size_t lane) const { return {nearest[0][lane], nearest[1][lane], nearest[2][lane]}; }
};

/// Measures the distances of the point from triangles in the world. The same bits at every SIMD level, and as
/// `distance` of the point and the triangle as convex shapes.
void measure(const Vec3& point, const TriangleBlock& triangles, PointDistances& distances);

}  // namespace toccata
