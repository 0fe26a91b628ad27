#pragma once

#include <optional>

#include "motion/moving_part.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {

/// The first meeting, within a stretch and no later than `limit`, of two parts of which one has a tree and whose
/// surfaces do not meet when the stretch begins. Elements are those of the parts, without place and faces. Counts are
/// added up.
///
/// The first contact is found by recursion in time: in a stretch all pairs of boxes are compared as they are at its two
/// ends, with what points of each box can bend in between (M. Tang, Y. J. Kim, D. Manocha, "C2A: Controlled
/// conservative advancement for continuous collision detection of polygonal models", 2009, bounds the motion of each
/// node so); pairs that travel farther in it than they are large are left for its two halves, the earlier of which
/// comes first, and are so halved until they are decided; others are opened, down to single items, whose first contact
/// is item_contact.hpp.
[[nodiscard]] std::optional<ShapeHit> tree_sweep(const MovingPart& a, const MovingPart& b, const TimeStretch& stretch,
                                                 double stop_before, double limit, WalkCounts& counts);

}  // namespace toccata
