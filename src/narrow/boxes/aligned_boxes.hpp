#pragma once

#include <optional>

#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// The distance of two boxes whose edges are parallel to the axes, in closed form; nothing for anything else, nor where
/// the rounding of a root is not certain.
[[nodiscard]] std::optional<Distance> aligned_box_distance(const PosedPolytope& a, const PosedPolytope& b);

/// The penetration of two such boxes, in canonical order, that meet inside: neighbouring doubles around the exact
/// depth; nothing for anything else.
[[nodiscard]] std::optional<Penetration> aligned_box_penetration(const PosedPolytope& a, const PosedPolytope& b);

/// Whether two such boxes have a point in common; nothing for anything else.
[[nodiscard]] std::optional<bool> aligned_boxes_meet(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
