#pragma once

#include "toccata/bounds/volume.hpp"

namespace toccata {

/// A cube along the axes: all points of which no coordinate is farther than `half` from the centre's. Empty while that
/// is negative.
struct Cube {
  static constexpr std::string_view name = "cube";
  static constexpr double microseconds = 0.2;

  Vec3 centre;
  double half = -1;
  friend constexpr bool operator==(const Cube&, const Cube&) = default;
};

/// The smallest cube, but for rounding; of those equally small the one in the middle of the box around the points.
template <>
Cube fit<Cube>(std::span<const Vec3> points);
template <>
Cube fit<Cube>(std::span<const Triangle> triangles);

[[nodiscard]] constexpr bool is_empty(const Cube& cube) { return cube.half < 0; }
[[nodiscard]] double support_bound(const Cube& cube, const Vec3& direction, const Vec3& from);
[[nodiscard]] Vec3 farthest_point(const Cube& cube, const Vec3& direction);
[[nodiscard]] inline Vec3 middle(const Cube& cube) { return cube.centre; }

[[nodiscard]] Cube merge(const Cube& a, const Cube& b);
[[nodiscard]] bool contains(const Cube& cube, const Vec3& point);
[[nodiscard]] Cube posed(const Cube& cube, const Pose& pose);
[[nodiscard]] Aabb box_around(const Cube& cube);
[[nodiscard]] double measure(const Cube& cube);
[[nodiscard]] double surface_area(const Cube& cube);
[[nodiscard]] double half_area(const Cube& cube);

}  // namespace toccata
