#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/vec3_measures.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Squares and products of three lengths over- or underflow for coordinates beyond 2^±300; what is only rounded anyway
// is computed of scaled copies then.
namespace toccata {

/// The greatest magnitude of a coordinate, or the radius.
[[nodiscard]] inline double greatest_length(const PosedPolytope& shape) {
  double greatest = shape.radius();
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const Vec3 v = shape.vertex(i);
    greatest = std::max({greatest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  }
  return greatest;
}

/// The power of two by which lengths of which this is the greatest become plain; 0 where they are.
[[nodiscard]] inline int exponent_to_plain(double greatest) {
  if (greatest == 0 || (greatest > 0x1p-300 && greatest < 0x1p300)) return 0;
  return std::clamp(-std::ilogb(greatest), -900, 900);
}

/// No coordinate of a vertex has a greater magnitude, but for rounding: in the time of one vertex.
[[nodiscard]] inline double greatest_at_most(const PosedPolytope& shape) {
  if (shape.in_world()) return greatest_length(shape);
  double greatest = shape.radius();
  for (int axis = 0; axis < 3; ++axis) {
    const double along = sum_of_magnitudes(shape.pose().linear[axis]) * shape.stored_extent();
    greatest = std::max(greatest, along + std::fabs(shape.pose().offset[axis]));
  }
  return greatest;
}

/// That power for two shapes.
[[nodiscard]] inline int exponent_to_plain(const PosedPolytope& a, const PosedPolytope& b) {
  const double most = std::max(greatest_at_most(a), greatest_at_most(b)), least = largest_magnitude(a.vertex(0));
  if (least > 0x1p-299 && most < 0x1p299) return 0;
  return exponent_to_plain(std::max(greatest_length(a), greatest_length(b)));
}

/// Back to the world; what would be infinite there stays finite.
[[nodiscard]] inline Manifold scaled(const Manifold& manifold, int exponent) {
  constexpr double limit = std::numeric_limits<double>::max();
  const auto times = [=](double x) { return std::clamp(std::scalbn(x, exponent), -limit, limit); };
  Manifold result = manifold;
  for (ManifoldPoint& point : result.points) {
    point.position = {times(point.position.x), times(point.position.y), times(point.position.z)};
    point.depth = times(point.depth);
  }
  return result;
}

}  // namespace toccata
