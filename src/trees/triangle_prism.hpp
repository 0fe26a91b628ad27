#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "toccata/math/vec3.hpp"
#include "trees/oriented_boxes.hpp"
#include "trees/prism_directions.hpp"

namespace toccata {

/// The prism that stands on a triangle (prism_directions.hpp).
class TrianglePrism {
 public:
  TrianglePrism() = default;
  explicit TrianglePrism(const std::array<Vec3, 3>& corners) {
    const std::array<Vec3, 4> directions = prism_directions(corners);
    for (std::size_t i = 0; i < 4; ++i) put(i, directions[i], corners);
  }

  /// How far the box of a lane is from it along one of the normals, in the block's units; 0 where none says more.
  [[nodiscard]] double gap(const OrientedBlock& block, std::size_t lane) const {
    const auto vector_at = [&](const auto& values) { return Vec3{values[0][lane], values[1][lane], values[2][lane]}; };
    const Vec3 centre = vector_at(block.centre), extent = vector_at(block.extent);
    const Vec3 first = vector_at(block.axis[0]), second = vector_at(block.axis[1]), third = cross(first, second);
    double greatest = 0;
    for (const Side& side : sides_) {
      const double at = dot(side.normal, centre);
      const double reach =
          (extent.x * std::abs(dot(side.normal, first)) + extent.y * std::abs(dot(side.normal, second))) +
          extent.z * std::abs(dot(side.normal, third));
      greatest = std::max({greatest, (at - reach) - side.high, (side.low - at) - reach});
    }
    return greatest;
  }

 private:
  struct Side {
    Vec3 normal;  ///< of length 1 but for rounding, or zero
    double low = 0;
    double high = 0;
  };

  void put(std::size_t i, const Vec3& normal, const std::array<Vec3, 3>& corners) {
    const auto [low, high] = std::minmax({dot(normal, corners[0]), dot(normal, corners[1]), dot(normal, corners[2])});
    sides_[i] = {normal, low, high};
  }

  std::array<Side, 4> sides_;
};

}  // namespace toccata
