#pragma once

#include "narrow/quadrics/inside/unit_frame.hpp"

// Whether a quadric holds another convex shape, or is held by it. `held` and `holder` are the bodies of the two in
// one frame.
namespace toccata {

/// A hull within a quadric, grown or not. A solid may reach the boundary, a surface may not.
[[nodiscard]] Within is_held_by_quadric_body(const PosedPolytope& shape, const QuadricBody& held,
                                             const PosedQuadric& by, const QuadricBody& holder);

/// A quadric within a convex one that has an interior.
[[nodiscard]] Within is_held_by_convex(const QuadricBody& held, const PosedPolytope& by, const QuadricBody& holder,
                                       const PairFrame& frame);

/// A quadric within another.
[[nodiscard]] Within is_held_by_quadric_body(const QuadricBody& held, const QuadricBody& holder);

/// Within the points that are at most `radius` from the hull of some vertices, all in the frame of the body. By halving
/// what is left of the body's extreme points, as the distance from the hull is a convex function.
[[nodiscard]] Within is_held_by_offset(const QuadricBody& held, const PosedPolytope& core, double radius);

}  // namespace toccata
