#pragma once

#include "toccata/narrow/casts.hpp"

namespace toccata {

/// A ray and what is asked of it again and again. `largest` is the greatest magnitude of a coordinate of the motion.
struct PreparedRay {
  PreparedRay(const Vec3& from, const Vec3& along);
  Vec3 origin;
  Vec3 motion;
  double largest;
};

/// Not less than any RayTime is wide, which is at most 2^-41 of the way but for rounding.
inline constexpr double widest_time = 0x1p-40;

/// When a ray meets a triangle: the exact time lies in [lower, upper], which is at most 2^-41 of the way wide.
struct RayTime {
  bool hit = false;
  double lower = 0;
  double upper = 0;
  bool exact = false;  ///< by exact arithmetic, because nothing else told
};

/// A function of the ray and the triangle alone. In doubles where that is certain, else exact.
[[nodiscard]] RayTime ray_time(const PreparedRay& ray, const Triangle& target);

/// The same, of a triangle that the ray's line is known to pass through, not in its plane.
[[nodiscard]] RayTime ray_time_of_passing(const PreparedRay& ray, const Triangle& target);

/// The whole answer, for a triangle that is met at that time.
[[nodiscard]] Cast ray_hit(const PreparedRay& ray, const Triangle& target, const RayTime& time);

}  // namespace toccata
