#pragma once

#include <array>
#include <cmath>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// The eight corners of a box in the world, numbered as Box::corner does; coordinates axis by axis.
struct BoxCorners {
  alignas(64) std::array<std::array<double, 8>, 3> coordinate;

  [[nodiscard]] std::array<const double*, 3> along() const {
    return {coordinate[0].data(), coordinate[1].data(), coordinate[2].data()};
  }
};

/// The world vertices of docs/truth.md, bit by bit: corners share coordinates, so their products and first sums are
/// made once. They may overflow; the sum of their magnitudes over each axis, which is returned, is then not finite.
inline Vec3 place_corners(const Box& box, const Pose& pose, std::array<std::array<double, 8>, 3>& corner) {
  const Vec3 lower = box.centre() - box.half_extents(), upper = box.centre() + box.half_extents();
  Vec3 sum;
  for (int i = 0; i < 3; ++i) {
    const Vec3& row = pose.linear[i];
    const double x[2] = {row.x * lower.x, row.x * upper.x}, y[2] = {row.y * lower.y, row.y * upper.y};
    const double z[2] = {row.z * lower.z, row.z * upper.z};
    const double in_plane[4] = {x[0] + y[0], x[1] + y[0], x[0] + y[1], x[1] + y[1]};
    double* const to = corner[static_cast<std::size_t>(i)].data();
    for (std::size_t k = 0; k < 4; ++k) {
      to[k] = (in_plane[k] + z[0]) + pose.offset[i];
      to[k + 4] = (in_plane[k] + z[1]) + pose.offset[i];
      sum[i] += std::fabs(to[k]) + std::fabs(to[k + 4]);
    }
  }
  return sum;
}

[[nodiscard]] inline BoxCorners world_corners(const Box& box, const Pose& pose) {
  BoxCorners corners;
  place_corners(box, pose, corners.coordinate);
  return corners;
}

}  // namespace toccata
