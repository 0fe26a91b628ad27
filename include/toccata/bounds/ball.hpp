#pragma once

#include "toccata/bounds/volume.hpp"

namespace toccata {

/// All points within `radius` of the centre. Empty while the radius is negative.
struct Ball {
  static constexpr std::string_view name = "ball";
  static constexpr double microseconds = 1;

  Vec3 centre;
  double radius = -1;
  friend constexpr bool operator==(const Ball&, const Ball&) = default;
};

/// The smallest ball, but for rounding (E. Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991; the points
/// it looks at are chosen after B. Gärtner, "Fast and robust smallest enclosing balls", 1999). Whatever the search
/// finds, the radius is measured anew from its centre: every point is inside. The ball around the corners is that
/// around the triangles, since balls are convex.
template <>
Ball fit<Ball>(std::span<const Vec3> points);
template <>
Ball fit<Ball>(std::span<const Triangle> triangles);

/// A ball around the points, made in two passes over them, and on average some per cent larger than the smallest (J.
/// Ritter, "An efficient bounding sphere", 1990). Measured anew as well.
[[nodiscard]] Ball fit_ball_fast(std::span<const Vec3> points);

[[nodiscard]] constexpr bool is_empty(const Ball& ball) { return ball.radius < 0; }
[[nodiscard]] double support_bound(const Ball& ball, const Vec3& direction, const Vec3& from);
[[nodiscard]] Vec3 farthest_point(const Ball& ball, const Vec3& direction);
[[nodiscard]] inline Vec3 middle(const Ball& ball) { return ball.centre; }

/// The smallest ball around both, but for rounding.
[[nodiscard]] Ball merge(const Ball& a, const Ball& b);
[[nodiscard]] bool contains(const Ball& ball, const Vec3& point);
/// Proved; false also where it is a matter of the last places. An empty ball is in every one.
[[nodiscard]] bool contains(const Ball& outer, const Ball& inner);
/// The radius grows by what the pose can stretch: not at all, but for rounding, under a rotation.
[[nodiscard]] Ball posed(const Ball& ball, const Pose& pose);
[[nodiscard]] Aabb box_around(const Ball& ball);
[[nodiscard]] double measure(const Ball& ball);
[[nodiscard]] double surface_area(const Ball& ball);
[[nodiscard]] double half_area(const Ball& ball);
[[nodiscard]] inline RoundVolume round_volume(const Ball& ball) {
  const double r = ball.radius;
  return {ball.centre, {}, {Vec3{r, 0, 0}, Vec3{0, r, 0}, Vec3{0, 0, r}}};
}

}  // namespace toccata
