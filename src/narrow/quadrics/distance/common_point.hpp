#pragma once

#include <optional>

#include "narrow/quadrics/distance/quadric_nearest.hpp"
#include "narrow/quadrics/pair_frame.hpp"

namespace toccata {

// Where the search left open whether two shapes meet: a world point that exact signs find in both. Looked at are the
// nearest points that were found, as they are, with the last digits rounded away, and with coordinates of the middles,
// poles, rims and corners that are next to theirs; and these points themselves. So shapes that touch along the axes
// have one wherever a double's coordinates are in both.
[[nodiscard]] std::optional<Vec3> common_point(const PosedQuadric& a, const PosedQuadric& b,
                                               const QuadricNearest& found, const PairFrame& frame);
[[nodiscard]] std::optional<Vec3> common_point(const PosedQuadric& a, const PosedPolytope& b,
                                               const QuadricNearest& found, const PairFrame& frame);

}  // namespace toccata
