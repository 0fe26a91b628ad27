#pragma once

#include "toccata/narrow/convex_convex.hpp"

// The numbers of a pair are computed in one order of the two and exchanged for the other, so that both orders have the
// same bits.
namespace toccata {

/// A comes first: by vertices, then by radius. Shapes of which neither comes before the other are the same.
[[nodiscard]] bool is_canonical_order(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
