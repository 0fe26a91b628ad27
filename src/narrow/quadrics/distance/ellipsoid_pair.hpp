#pragma once

#include <optional>

#include "narrow/quadrics/distance/fast_proof.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// The distance of two ellipsoids with rigid poses that are apart, proved, by Newton's method on the direction between
/// them, from the given one or, where that is zero, from that of their middles. What it does not answer, any other pair
/// of shapes among it, is left to `FastPair`.
[[nodiscard]] std::optional<FastDistance> ellipsoid_distance(const PosedQuadric& a, const PosedQuadric& b,
                                                             const Vec3& first_direction);

/// Of such a pair, apart or contact where that is certain: by the first direction on that way across which they are
/// apart, or where the line between the middles leaves neither before it enters the other.
[[nodiscard]] std::optional<QuadricContact> ellipsoid_contact(const PosedQuadric& a, const PosedQuadric& b);

}  // namespace toccata
