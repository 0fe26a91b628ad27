#pragma once

#include <optional>

#include "narrow/smooth/smooth_body.hpp"

namespace toccata {

/// The times at which a line is in a smooth shape, where they are certain.
struct LineWithin {
  bool empty = false;  ///< the line certainly misses
  BoundedNumber enters;
  BoundedNumber leaves;
  Vec3 normal;  ///< outwards where it enters, in the pair's frame; not of length 1
};

/// Of the line from + t · along, in the pair's frame, by the roots of one quadratic equation in the frame in which the
/// shape is round. Empty where rounding leaves a root or an order in doubt.
[[nodiscard]] std::optional<LineWithin> line_within(const SmoothBody& smooth, const BoundedVector& from,
                                                    const BoundedVector& along);

}  // namespace toccata
