#pragma once

#include <optional>

#include "narrow/quadrics/distance/fast_proof.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// The distance of a shape that is round about an axis (AxialKind) and a box where both poses are rigid and they are
/// apart, proved, by closed forms for the nearest point of the round shape to a point and for the sides of the box, and
/// Newton's method along edges. What it does not answer, any other pair of shapes among it, is left to `FastPair`.
[[nodiscard]] std::optional<FastDistance> axial_box_distance(const PosedQuadric& a, const PosedPolytope& b);

/// The contact of such a pair, apart or contact where that is certain: contact, where the search comes to a point of
/// the box that lies within the round shape.
[[nodiscard]] std::optional<QuadricContact> axial_box_contact(const PosedQuadric& a, const PosedPolytope& b);

}  // namespace toccata
