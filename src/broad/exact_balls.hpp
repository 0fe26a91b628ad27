#pragma once

#include "toccata/bounds/aabb.hpp"
#include "toccata/bounds/ball.hpp"

namespace toccata {

/// Whether they have a point in common: exact, for any numbers that are not refused, and so the same in either order.
/// Neither is empty.
[[nodiscard]] bool balls_meet(const Ball& a, const Ball& b);
[[nodiscard]] bool ball_meets_box(const Ball& ball, const Aabb& box);

}  // namespace toccata
