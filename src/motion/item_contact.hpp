#pragma once

#include <optional>

#include "motion/first_contact.hpp"
#include "motion/moving_part.hpp"

namespace toccata {

/// The first contact of an item of each of two parts: of a mesh the triangle of that number, of a convex shape itself.
[[nodiscard]] std::optional<FirstContact> item_contact(const MovingPart& a, Index item_a, const MovingPart& b,
                                                       Index item_b, const TimeStretch& stretch,
                                                       const GapBounds& bounds, double stop_before);

/// How near they are at a time, and where.
[[nodiscard]] Distance item_distance(const MovingPart& a, Index item_a, const MovingPart& b, Index item_b, double time);

}  // namespace toccata
