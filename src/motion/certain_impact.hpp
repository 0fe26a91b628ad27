#pragma once

#include "core/certain_answer.hpp"
#include "motion/moving_polygon.hpp"

namespace toccata {

/// As far as doubles, and numbers of twice their length, are certain.
[[nodiscard]] CertainAnswer<TimeOfImpact> certain_time_of_impact(const MovingPolygon<3>& polygon);
[[nodiscard]] CertainAnswer<TimeOfImpact> certain_time_of_impact(const MovingPolygon<4>& polygon);

}  // namespace toccata
