#pragma once

#include <optional>

#include "math/number_vector.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// The times of the way, from 0 to 1, at which a point that moves along a line is in a quadric. What lies beyond
/// these may be taken for unbounded.
template <class Number>
struct LineWithin {
  bool empty = false;  ///< the way certainly misses
  Number enters{};
  Number leaves{};
  Vec3 normal;  ///< outwards where it enters, in the frame of the axes; not of length 1
};

/// The images of the half axes of a shape that is round where these are the axes, of the radius twice and the half
/// height; and a line, seen from its middle.
template <class Number>
struct RoundAndLine {
  PosedQuadric::Kind kind{};
  std::array<VectorOf<Number>, 3> axis{};
  VectorOf<Number> from{};
  VectorOf<Number> along{};
};

/// By the roots of one quadratic equation in the frame in which the shape is round. Empty where rounding leaves a root
/// or an order in doubt.
template <class Number>
[[nodiscard]] std::optional<LineWithin<Number>> line_within(const RoundAndLine<Number>& given);

/// The same of one in doubles: `axis` and `from` are off by a rounding each, `along` is exact.
[[nodiscard]] std::optional<LineWithin<BoundedDouble>> fast_line_within(PosedQuadric::Kind kind,
                                                                        const std::array<Vec3, 3>& axis,
                                                                        const Vec3& from, const Vec3& along);

}  // namespace toccata
