#pragma once

#include <optional>

#include "narrow/smooth/distance/quick_proof.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata {

/// The distance of a cylinder or a cone and a box where both poses are rigid and they are apart, proved, by closed
/// forms for the nearest point of the round shape to a point and for the sides of the box, and Newton's method along
/// edges. What it does not answer, any other pair of shapes among it, is left to `QuickPair`.
[[nodiscard]] std::optional<QuickDistance> axial_box_distance(const PosedSmooth& a, const PosedConvex& b);

/// Of such a pair, apart or contact where that is certain: contact, where the search comes to a point of the box that
/// lies within the round shape.
[[nodiscard]] std::optional<SmoothContact> axial_box_contact(const PosedSmooth& a, const PosedConvex& b);

}  // namespace toccata
