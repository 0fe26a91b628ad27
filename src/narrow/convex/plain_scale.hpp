#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

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
