#pragma once

#include "narrow/triangles/triangle_gaps.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// A direction from a to b, and how far b is from a along it.
struct GapDirection {
  Vec3 direction;  ///< of length 1 but for rounding, or 0
  double gap = 0;  ///< the least direction · (q − p) of points p of a and q of b, up to 2⁻⁴⁸ of the greatest |v − a[0]|
};

/// Along the difference of the points that `bound_gaps` found for the two.
[[nodiscard]] GapDirection gap_direction(const Triangle& a, const Triangle& b, const TriangleGaps::Points& points);

}  // namespace toccata
