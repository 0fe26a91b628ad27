#pragma once

#include "toccata/narrow/posed_shapes.hpp"

// Two boxes by the fifteen axes along which they can be separated: the normals of the three faces of each, and the
// cross products of their edges (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996). The same exact answers as for
// any two convex shapes (convex_convex.hpp), which take this way too.
namespace toccata {

/// Do they have a point in common? Touching counts.
[[nodiscard]] bool overlap(const PosedBox& a, const PosedBox& b);

}  // namespace toccata
