#pragma once

#include "math/vec3_measures.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// How far a world corner may be beside centre ± half extents · columns, for the rounded world centre and a pose that
/// hardly deforms.
///
/// Let u = 2^-53, M the sum of |R| (|c| + h) over all products and |t| the sum of the offset's magnitudes. A world
/// corner is off by 4u M + u |t| at most (three products, three sums), by u M more where its local coordinates were
/// rounded, and the centre by 4u M + u |t|; about the origin of the shape's frame the last two are exact. A column of a
/// rigid pose has a sum of at most 1.74. The bounds below have a few percent to spare; underflow loses less than
/// 2^-1000.
inline double slack_of(const Box& box, const Pose& pose) {
  const double offset = sum_of_magnitudes(pose.offset), halves = sum_of_magnitudes(box.half_extents());
  const double centre = sum_of_magnitudes(box.centre());
  const double roundings = centre == 0 ? 7.5 * halves + 1.25 * offset : 16.5 * (halves + centre) + 2.25 * offset;
  return 0x1p-53 * roundings + 0x1p-1000;
}

}  // namespace toccata
