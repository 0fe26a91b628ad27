#pragma once

#include <array>

#include "methods/voronoi/feature_walk.hpp"

namespace toccata {

/// A vertex of each shape, where a walk begins about which nothing is known: those that are the farthest along the way
/// from the middle of one shape to that of the other, but for rounding. On a large hull they are found by walking along
/// edges from where its guide says.
[[nodiscard]] std::array<Index, 2> facing_vertices(const PosedPolytope& a, const WalkBody& body_a,
                                                   const PosedPolytope& b, const WalkBody& body_b);

}  // namespace toccata
