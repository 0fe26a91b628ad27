#pragma once

#include "narrow/exact/exact_nearest.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// The shapes, grown by their radii, have a point in common.
[[nodiscard]] bool offset_shapes_meet(const ExactNearest& nearest, double radius_a, double radius_b);

/// The sign of (distance of the cores) − (x + y), exactly; x + y is not negative.
[[nodiscard]] Sign compare_core_distance(const ExactNearest& nearest, double x, double y);

/// The sign of (distance of the cores) − (radius_a + radius_b + length), exactly; the sum is not negative.
[[nodiscard]] Sign compare_offset_distance(const ExactNearest& nearest, double radius_a, double radius_b,
                                           double length);

/// The answer of `distance`, from the exact nearest points of the cores.
///
/// Where the grown shapes meet and the cores do not, the common point is the one that divides the way from core to core
/// as the radii do.
[[nodiscard]] Distance rounded_distance(const ExactNearest& nearest, double radius_a, double radius_b);

}  // namespace toccata
