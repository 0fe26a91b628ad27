#pragma once

#include <optional>

#include "narrow/convex/convex_separation.hpp"

// Shapes whose cores are boxes with edges parallel to the axes, segments parallel to an axis or points: upright
// capsules, balls, boxes that are not turned, rounded or not. Faces and edges of such are often parallel, so that the
// nearest points are not unique and only exact arithmetic could choose among them; here they are the least coordinate
// by coordinate, which is what it would choose. Nothing is told of anything else, nor where the rounding of a root is
// not certain.
namespace toccata {

[[nodiscard]] std::optional<Distance> distance_of_aligned_cores(const PosedPolytope& a, const PosedPolytope& b);

/// Whether two such shapes have a point in common.
[[nodiscard]] std::optional<bool> aligned_cores_meet(const PosedPolytope& a, const PosedPolytope& b);

/// The separation of two such shapes, in canonical order, one of which has a radius or which meet inside: neighbouring
/// doubles around the exact depth. Without pairs of vertices where the cores meet.
[[nodiscard]] std::optional<ConvexSeparation> part_aligned_cores(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
