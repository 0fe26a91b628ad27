#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "math/vec3_measures.hpp"
#include "motion/nearest_direction.hpp"
#include "motion/separating_direction.hpp"

// Distances of moving features, for those who prove that they stay more than a separation apart.
namespace toccata {

/// A moving polygon and a separation in a unit, a power of two, in which the largest coordinate is about 1: so that
/// products of several neither over- nor underflow. Where even a difference of two coordinates overflows, the largest
/// is infinite, and no comparison proves anything.
template <std::size_t Count>
struct ScaledPolygon {
  ScaledPolygon(const MovingPolygon<Count>& polygon, double unscaled_separation) : corners(rounded(polygon)) {
    const Vec3 greatest = greatest_magnitudes(corners);
    factor = std::ldexp(1.0, std::clamp(-std::ilogb(largest_magnitude(greatest)), -1000, 1000));
    for (RoundedCorner& c : corners) c = {factor * c.start, factor * c.end};
    magnitude = greatest_magnitudes(corners);
    separation = factor * unscaled_separation;
  }

  [[nodiscard]] std::array<Vec3, Count> at(double t) const {
    std::array<Vec3, Count> q;
    for (std::size_t i = 0; i < Count; ++i) q[i] = (1 - t) * corners[i].start + t * corners[i].end;
    return q;
  }

  RoundedPolygon<Count> corners;
  Vec3 magnitude;  ///< of each coordinate, the greatest
  double separation = 0;
  double factor = 1;
};

/// The vector with a largest coordinate of 1; not finite where v is zero.
inline Vec3 of_largest_coordinate_one(const Vec3& v) { return v / largest_magnitude(v); }

/// A number not less than separation · |direction|, for a direction of that size, by far more than what comparisons
/// with it round.
inline double separation_along(const Vec3& direction, double separation) {
  return separation * (plain_length(direction) * (1 + 0x1p-44));
}

}  // namespace toccata
