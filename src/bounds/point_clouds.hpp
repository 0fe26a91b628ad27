#pragma once

#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// Coordinates up to here are fitted: below it no difference, sum of a few, or length overflows.
inline constexpr double greatest_fitted_coordinate = 0x1p1000;

/// The box around the points. Throws Error naming the first one with a coordinate that is not finite or too great.
[[nodiscard]] Aabb checked_box(std::span<const Vec3> points);

/// All corners, in order.
[[nodiscard]] std::vector<Vec3> corners_of(std::span<const Triangle> triangles);

[[nodiscard]] inline Vec3 centre_of(const Aabb& box) { return 0.5 * box.lower + 0.5 * box.upper; }

/// Moves points near 1 around a centre, so that squares neither under- nor overflow.
struct CloudScale {
  Vec3 centre;
  double factor = 1;

  explicit CloudScale(const Aabb& box);
  [[nodiscard]] Vec3 operator()(const Vec3& point) const { return factor * (point - centre); }
  [[nodiscard]] Vec3 back(const Vec3& scaled) const { return (1 / factor) * scaled + centre; }
};

}  // namespace toccata
