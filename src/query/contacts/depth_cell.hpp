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
  [[nodiscard]] Vec3 inside(const Vec3& world) const {
    const Vec3 from = world - origin;
    return {dot(axes[0], from), dot(axes[1], from), dot(axes[2], from)};
  }
};

/// Whose first axis is the direction, which is a unit vector.
[[nodiscard]] CellFrame frame_along(const Vec3& direction, const Vec3& origin);

/// Bounds of distances are valid for real numbers; each is more than its sum of products by that at least.
inline constexpr double depth_slack = 0x1p-44;

/// A nearest point is off by that many slacks at most, 10⁻¹² of the coordinates.
inline constexpr double slacks_of_nearest = 32;

/// A box in a frame, as points in the world.
struct DepthCell {
  Vec3 middle;
  std::array<Vec3, 8> corners;  ///< less the middle
  double radius = 0;            ///< no corner is farther from the middle
  std::array<Vec3, 3> axes;     ///< of its sides
};

/// Functions over a cell, told by their values at its corners, each convex and at each point of the cell inside the
/// solid at least its distance from the solid's surface.
struct DistanceBounds {
  std::size_t count = 0;  ///< none: no point of the cell is inside
  std::array<std::array<double, 8>, 3> at_corners{};
  Vec3 outwards{};            ///< about the way to the surface from inside
  std::size_t triangles = 0;  ///< that were looked at
  Vec3 bend{};  ///< how much the surface's normals differ from the height's direction along each axis of the cell
};

/// Bounds by the distance from the middle alone.
[[nodiscard]] DistanceBounds bounds_by_distance(const DepthSide& solid, const DepthSide::Place& middle,
                                                const DepthCell& cell, double slack);

/// Adds the height, along a direction, below the highest point of the surface over the cell; where what lies above
/// that is outside. None are left where this says that no point of the cell is inside.
void add_bound_by_height(const DepthSide& solid, const DepthSide::Place& middle, const DepthCell& cell,
                         const Vec3& upwards, double slack, DistanceBounds& bounds);

/// The greatest sum of distances that the bounds of both leave possible.
[[nodiscard]] double greatest_sum(const DistanceBounds& a, const DistanceBounds& b);

}  // namespace toccata
