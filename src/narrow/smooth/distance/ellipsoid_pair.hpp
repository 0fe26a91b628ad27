#pragma once

#include <optional>

#include "narrow/smooth/distance/quick_proof.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata {

/// The distance of two ellipsoids with rigid poses that are apart, proved, by Newton's method on the direction between
/// them, from the given one or, where that is zero, from that of their middles. What it does not answer, any other pair
/// of shapes among it, is left to `QuickPair`.
[[nodiscard]] std::optional<QuickDistance> ellipsoid_distance(const PosedSmooth& a, const PosedSmooth& b,
                                                              const Vec3& first_direction);

/// Of such a pair, apart or contact where that is certain: by the first direction on that way across which they are
/// apart, or where the line between the middles leaves neither before it enters the other.
[[nodiscard]] std::optional<SmoothContact> ellipsoid_contact(const PosedSmooth& a, const PosedSmooth& b);

}  // namespace toccata
