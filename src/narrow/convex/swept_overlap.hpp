#pragma once

#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// A, moved by time · motion for some time in [0, `until`], has a point in common with B. Exact: the hull of A and of
/// A moved, grown by both radii, against B, in integers. `until` is positive.
///
/// The search of exact_nearest.hpp, where every vertex of A stands for itself and for itself moved; it ends for the
/// same reason.
[[nodiscard]] bool swept_meets(const PosedPolytope& a, const Vec3& motion, double until, const PosedPolytope& b);

}  // namespace toccata
