#pragma once

#include <array>

#include "toccata/bounds/ball.hpp"
#include "toccata/bounds/ellipsoid_bound.hpp"
#include "toccata/bounds/swept_sphere.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata::io {

/// A volume with a round surface, as what it is: all centre ± core₀ ± core₁ + Σ d_i · axis_i with |d| = 1, and what
/// lies between. Balls have no core, ellipsoids none and axes of several lengths, swept spheres one or two.
struct RoundVolume {
  Vec3 centre;
  std::array<Vec3, 2> core{};
  std::array<Vec3, 3> axis;
};

[[nodiscard]] inline RoundVolume round_volume(const Ball& ball) {
  const double r = ball.radius;
  return {ball.centre, {}, {Vec3{r, 0, 0}, Vec3{0, r, 0}, Vec3{0, 0, r}}};
}

template <std::size_t dimension>
[[nodiscard]] RoundVolume round_volume(const SweptSphere<dimension>& volume) {
  const double r = volume.radius;
  RoundVolume round{volume.centre, {}, {r * volume.axes[0], r * volume.axes[1], r * volume.axes[2]}};
  for (std::size_t i = 0; i < dimension; ++i) round.core[i] = volume.half[i] * volume.axes[static_cast<int>(i)];
  return round;
}

[[nodiscard]] inline RoundVolume round_volume(const EllipsoidBound& volume) {
  return {volume.centre,
          {},
          {volume.half.x * volume.axes[0], volume.half.y * volume.axes[1], volume.half.z * volume.axes[2]}};
}

}  // namespace toccata::io
