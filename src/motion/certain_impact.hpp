#pragma once

#include <optional>

#include "motion/moving_polygon.hpp"

namespace toccata {

/// What doubles, and numbers of twice their length, are certain of: the answer, or nothing.
[[nodiscard]] std::optional<TimeOfImpact> certain_time_of_impact(const MovingPolygon<3>& polygon);
[[nodiscard]] std::optional<TimeOfImpact> certain_time_of_impact(const MovingPolygon<4>& polygon);

}  // namespace toccata
