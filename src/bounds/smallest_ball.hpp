#pragma once

#include <span>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// The centre of the smallest ball around points of magnitude about 1, as far as doubles tell; at least one point.
[[nodiscard]] Vec3 smallest_ball_centre(std::span<const Vec3> points);

}  // namespace toccata
