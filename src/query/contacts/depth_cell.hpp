#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "query/contacts/region_depth.hpp"

namespace toccata {

/// Axes at right angles to each other, up to rounding.
struct CellFrame {
  Vec3 origin;
  std::array<Vec3, 3> axes;

  [[nodiscard]] Vec3 in_world(const Vec3& s) const { return origin + s.x * axes[0] + s.y * axes[1] + s.z * axes[2]; }
};

/// Whose first axis is the direction, which is a unit vector.
[[nodiscard]] CellFrame frame_along(const Vec3& direction, const Vec3& origin);

/// Bounds of distances are valid for real numbers; each is more than its sum of products by that at least.
inline constexpr double depth_slack = 0x1p-44;

/// A box in a frame, as points in the world.
struct DepthCell {
  Vec3 middle;
  std::array<Vec3, 8> corners;  ///< less the middle
  double radius = 0;            ///< no corner is farther from the middle
};

/// Functions over a cell, told by their values at its corners, each convex and at each point of the cell inside the
/// solid at least its distance from the solid's surface.
struct DistanceBounds {
  std::size_t count = 0;  ///< none: no point of the cell is inside
  std::array<std::array<double, 8>, 2> at_corners{};
  Vec3 outwards{};  ///< about the way to the surface from inside
};

/// By the distance from the middle alone.
[[nodiscard]] DistanceBounds bounds_by_distance(const DepthSide& solid, const DepthSide::Place& middle,
                                                const DepthCell& cell, double slack);

/// Adds the height below the highest point of the surface above the cell, where what lies above that is outside.
void add_bound_by_height(const DepthSide& solid, const DepthSide::Place& middle, const DepthCell& cell, double slack,
                         DistanceBounds& bounds);

/// The greatest sum of distances that the bounds of both leave possible.
[[nodiscard]] double greatest_sum(const DistanceBounds& a, const DistanceBounds& b);

}  // namespace toccata
