#pragma once

#include "narrow/smooth/inside/unit_frame.hpp"

// Whether a smooth shape holds another convex shape, or is held by it. `held` and `holder` are the bodies of the two in
// one frame.
namespace toccata {

/// A hull within a smooth shape, grown or not. A solid may reach the boundary, a surface may not.
[[nodiscard]] Within is_held_by_smooth(const PosedConvex& shape, const SmoothBody& held, const PosedSmooth& by,
                                       const SmoothBody& holder);

/// A smooth shape within a convex one that has an interior.
[[nodiscard]] Within is_held_by_convex(const SmoothBody& held, const PosedConvex& by, const SmoothBody& holder,
                                       const PairFrame& frame);

/// A smooth shape within another.
[[nodiscard]] Within is_held_by_smooth(const SmoothBody& held, const SmoothBody& holder);

/// Within the points that are at most `radius` from the hull of some vertices, all in the frame of the body. By halving
/// what is left of the body's extreme points, as the distance from the hull is a convex function.
[[nodiscard]] Within is_held_by_grown(const SmoothBody& held, const PosedConvex& core, double radius);

}  // namespace toccata
