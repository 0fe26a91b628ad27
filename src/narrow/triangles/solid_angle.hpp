#pragma once

#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// A part of the whole sphere of directions, at most 1/2 in magnitude. The exact one is within `bound` of `value`.
struct SolidAngle {
  double value = 0;
  double bound = 0;
};

/// How much of the sphere around the point the triangle covers; positive where it is seen from its back, which is the
/// side that its normal does not point to. Exactly 0 in its plane. The sign is exact. All numbers are finite. By the
/// formula of A. Van Oosterom, J. Strackee, "The solid angle of a plane triangle", 1983, in doubles or, near an edge,
/// in 106 bits; its bound is derived in docs/methods/winding-numbers.md.
[[nodiscard]] SolidAngle solid_angle(const Vec3& point, const Triangle& triangle);

/// atan2(y, x) as a part of a whole turn, off by at most 2⁻⁵¹; the same bits on every platform. Not both are 0.
[[nodiscard]] double turns_of(double y, double x);

}  // namespace toccata
