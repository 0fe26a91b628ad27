#pragma once

#include <vector>

#include "math/wide_integer.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// All world vertices at which direction · vertex is least, exactly; ascending. The direction is not zero.
[[nodiscard]] std::vector<Index> least_vertices(const PosedPolytope& shape, const IntegerVector& direction);

}  // namespace toccata
