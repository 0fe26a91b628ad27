#pragma once

#include <optional>

#include "motion/first_contact.hpp"
#include "motion/moving_part.hpp"

namespace toccata {

/// The first contact of an item of each of two parts: of a mesh the triangle of that number, of a convex shape itself.
[[nodiscard]] std::optional<FirstContact> item_contact(const MovingPart& a, Index item_a, const MovingPart& b,
                                                       Index item_b, const TimeStretch& stretch,
                                                       const GapBounds& bounds, double stop_before);

/// The point of the second item that is nearest to the first at a time, nearly; a point of both where they overlap.
[[nodiscard]] Vec3 item_point_on_b(const MovingPart& a, Index item_a, const MovingPart& b, Index item_b, double time);

}  // namespace toccata
