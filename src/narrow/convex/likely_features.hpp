#pragma once

#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// A simplex of the features that are most likely the nearest, by a formula in doubles: of which nothing is proved.
/// Empty where there is no formula.
[[nodiscard]] VertexPairs likely_features(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
