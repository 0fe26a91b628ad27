#pragma once

#include <optional>

#include "toccata/narrow/convex_convex.hpp"

// Straight casts: a point or a convex shape moves along a vector, and the first time at which it meets another is
// asked. Where nothing is met, which is proved, there is no answer.
namespace toccata {

/// The exact first time in [0, 1] lies in [lower, upper]; 0 when the sets meet at the start.
struct Cast {
  double lower = 0;
  double upper = 0;
  Vec3 point{};   ///< where they meet then, rounded
  Vec3 normal{};  ///< unit, from the target to what moves; zero when they meet at the start (of models: ShapeHit)
  Status status = Status::exact;
  friend constexpr bool operator==(const Cast&, const Cast&) = default;
};

/// A ray from `origin` to `origin + motion`: the time is the fraction of the way. Throws Error when a number is not
/// finite or the motion is zero.
[[nodiscard]] std::optional<Cast> cast_ray(const Vec3& origin, const Vec3& motion, const PosedPolytope& target);
[[nodiscard]] std::optional<Cast> cast_ray(const Vec3& origin, const Vec3& motion, const PosedHalfSpace& target);

/// A moves by `motion`, without turning; B stands. Throws Error when the motion is not finite. A workspace saves time
/// at the start, and all of it where the plane that kept the shapes apart the last time does so again.
[[nodiscard]] std::optional<Cast> cast_shape(const PosedPolytope& a, const Vec3& motion, const PosedPolytope& b,
                                             SimplexCache* workspace = nullptr);
[[nodiscard]] std::optional<Cast> cast_shape(const PosedPolytope& a, const Vec3& motion, const PosedHalfSpace& b);

}  // namespace toccata
