#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_shapes.hpp"

// Two boxes by the fifteen axes along which they can be separated: the normals of the three faces of each, and the
// cross products of their edges (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996). The same answers, to the bit,
// as those for any two convex shapes (convex_convex.hpp), which take this way where both are boxes. Under poses that
// deform, and where rounding leaves a doubt, the general way decides.
namespace toccata {

/// Do they have a point in common? Touching counts. Exact.
[[nodiscard]] bool overlap(const PosedBox& a, const PosedBox& b);

[[nodiscard]] Penetration penetration(const PosedBox& a, const PosedBox& b);

/// Empty exactly when the boxes are apart.
[[nodiscard]] Manifold manifold(const PosedBox& a, const PosedBox& b);

// The same of boxes that are asked about once: faster than to pose them before. Throw Error as PosedBox does.
[[nodiscard]] bool overlap(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b);
[[nodiscard]] Penetration penetration(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b);
[[nodiscard]] Manifold manifold(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b);

}  // namespace toccata
