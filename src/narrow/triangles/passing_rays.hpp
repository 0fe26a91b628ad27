#pragma once

#include <span>

#include "narrow/triangles/ray_triangle.hpp"

namespace toccata {

/// A ray and a triangle that its line is known to pass through, not in its plane.
struct PassingRay {
  const PreparedRay* ray;
  Triangle target;
};

/// ray_hit(ray, target, ray_time_of_passing(ray, target)), to the last bit, where doubles tell that it is a hit.
struct PassingHit {
  bool told = false;
  Cast cast;
};

[[nodiscard]] PassingHit hit_of_passing(const PassingRay& passing);

/// The same for several, side by side; `hits` is as long.
void hits_of_passing(std::span<const PassingRay> rays, std::span<PassingHit> hits);

}  // namespace toccata
