#pragma once

#include "toccata/narrow/quadrics.hpp"

namespace toccata {

// Is the exact distance at most the tolerance (world units, not negative)? False is proved; true where the tolerance
// lies within the interval of the distance, and where they may meet. Told as soon as a plane or two points show it.
[[nodiscard]] bool is_within(const PosedQuadric& a, const PosedQuadric& b, double tolerance);
[[nodiscard]] bool is_within(const PosedQuadric& a, const PosedPolytope& b, double tolerance);
[[nodiscard]] bool is_within(const PosedQuadric& a, const PosedHalfSpace& b, double tolerance);

}  // namespace toccata
