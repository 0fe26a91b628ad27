#pragma once

#include "narrow/convex/core_separation.hpp"
#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// The shortest way to part two shapes that meet, solid or not, and the vertices of the cores between which it was
/// found: those whose hulls hold the two points. For surfaces, and for shapes that touch, it is a direction along which
/// they can be parted; both bounds are 0 then. Nothing of use when the shapes are apart.
struct ConvexSeparation {
  Penetration penetration;
  VertexPairs pairs;
};

/// The penetration of shapes whose cores' interiors meet: the radii add to the cores' depth.
[[nodiscard]] Penetration offset_outward(const CoreSeparation& core, double radius_a, double radius_b);

/// Parts the shapes by expansion. The answer for (B, A) may have other bits: ask in canonical order.
[[nodiscard]] ConvexSeparation part_by_expansion(const PosedPolytope& a, const PosedPolytope& b);

/// The same where it is known that even the cores have a point in common; quicker then. `width`: of the depth's
/// bracket, relative, at most.
[[nodiscard]] ConvexSeparation part_meeting_cores(const PosedPolytope& a, const PosedPolytope& b,
                                                  double width = relative_width_of_depth);

}  // namespace toccata
