#pragma once

#include <optional>

#include "math/constants.hpp"
#include "narrow/quadrics/distance/fast_proof.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// The distance of two ellipsoids with rigid poses that are apart, proved, by Newton's method on the direction between
/// them, from the given one or, where that is zero, from that of their middles. What it does not answer, any other pair
/// of shapes among it, is left to `FastPair`.
[[nodiscard]] std::optional<FastDistance> ellipsoid_distance(const PosedQuadric& a, const PosedQuadric& b,
                                                             const Vec3& first_direction);

/// The contact of such a pair, apart or contact where that is certain: by the first direction on that way across which
/// they are apart, or where the line between the middles leaves neither before it enters the other.
[[nodiscard]] std::optional<QuadricContact> ellipsoid_contact(const PosedQuadric& a, const PosedQuadric& b);

/// Points are drawn in by this part, as in fast_proof.cpp.
inline constexpr double ellipsoid_drawn_in = 10 * unit_roundoff;

/// A point of the unit ball towards v, whose rounded length this is. Its coordinates, each multiplied by a half axis
/// and rounded, are a point of the ellipsoid.
[[nodiscard]] inline Vec3 drawn_into_ball(const Vec3& v, double length) {
  return ((1 - ellipsoid_drawn_in) / length) * v;
}

}  // namespace toccata
