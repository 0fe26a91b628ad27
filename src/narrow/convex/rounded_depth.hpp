#pragma once

#include <optional>

#include "narrow/exact/exact_nearest.hpp"
#include "narrow/exact/nearest_certificate.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// The penetration of two grown cores that do not overlap themselves: the sum of the radii less the distance of the
/// cores, each bound the neighbouring double or the number itself. The direction and the points are those of the cores'
/// nearest points; where the cores touch, `direction` has to be given: one along which they do not overlap.
[[nodiscard]] Penetration rounded_depth(const ExactNearest& nearest, double radius_a, double radius_b,
                                        const Vec3& direction_when_touching);

/// How far to move along a direction that is rounded, a unit vector up to 2^-50 that may point as far beside, to get as
/// far as the depth along the exact one.
[[nodiscard]] double enough_along(const Vec3& direction, double depth);

/// `rounded_depth` from nearest points that are unique and known as bounded numbers; nothing when these are not sharp
/// enough.
[[nodiscard]] std::optional<Penetration> rounded_depth(const CertainNearest& nearest, double radius_a, double radius_b);

}  // namespace toccata
