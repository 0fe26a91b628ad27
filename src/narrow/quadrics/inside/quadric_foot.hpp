#pragma once

#include <optional>

#include "narrow/quadrics/inside/unit_frame.hpp"

namespace toccata {

/// Where the quadric of a quadric (of a cylinder and a cone without end) is nearest to a point within it, off by
/// rounding. In the pair's frame.
struct QuadricFoot {
  VectorOf<DoubleWord> point;   ///< as seen from the quadric's origin
  VectorOf<DoubleWord> normal;  ///< outwards, of any length
  double multiplier = 0;        ///< what shows that the ball that touches there is within (`is_held_by`)
};

/// Nothing where numbers leave the range.
[[nodiscard]] std::optional<QuadricFoot> quadric_foot(const UnitFrame& shape, const BoundedVector& point);

}  // namespace toccata
