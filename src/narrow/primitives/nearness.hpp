#pragma once

#include "math/vec3_measures.hpp"
#include "toccata/math/vec3.hpp"

// How the closed formulas are made safe. A formula yields two near points, one of each core, and the vector d from one
// to the other, all in rounded doubles; nothing is believed of them. Two inequalities prove an answer, whatever d is:
// a point pair at distance |d| exists, so the grown cores meet if |d| is below the reach (the sum of the radii); and if
// no vertex of one core lies within (reach · |d|) of the vertices of the other along d, they are apart.
namespace toccata {

enum class Nearness { apart, meet, unknown };

/// What the formulas add to the error for every unit of magnitude that enters them: 128 roundings. Each coordinate of d
/// and each product with d goes through fewer than 20, and a length has at most √3 of what its coordinates have.
inline constexpr double nearness_bound = 0x1p-46;

/// What squares lose that underflow: where a length is greater, its square is off by far less than a rounding.
inline constexpr double nearness_floor = 0x1p-480;

/// What a formula's numbers may be off by. `magnitude` is the sum of the magnitudes of the coordinates that d was made
/// of, `slack` what the cores may differ by from the points taken for them.
inline double nearness_error(double reach, double magnitude, double slack = 0) {
  return nearness_bound * (magnitude + reach) + (slack + nearness_floor);
}

/// Parts of squares, for the roundings of the squares themselves and of their comparison: fewer than 8 of each side.
inline constexpr double less_square = 1 - 0x1p-48, more_square = 1 + 0x1p-48;

// Where something overflows or is NaN, both are false.

/// `length_squared` is d · d, of a d from a point of one core to a point of the other.
inline bool proves_meeting(double length_squared, double reach, double error) {
  const double inner = reach - error;
  return inner > 0 && length_squared < less_square * (inner * inner);
}

/// `gap_along` is the least product with d of a difference of core points; d may be any vector.
inline bool proves_apart(double gap_along, double length_squared, double reach, double error) {
  const double outer = reach + error;
  return gap_along > 0 && gap_along * gap_along > more_square * (outer * outer) * length_squared;
}

inline Nearness judge(double gap_along, double length_squared, double reach, double magnitude, double slack = 0) {
  const double error = nearness_error(reach, magnitude, slack);
  if (proves_meeting(length_squared, reach, error)) return Nearness::meet;
  return proves_apart(gap_along, length_squared, reach, error) ? Nearness::apart : Nearness::unknown;
}

inline double clamped(double value, double lower, double upper) {
  // In this order, NaN becomes `lower`.
  const double above = value > lower ? value : lower;
  return above < upper ? above : upper;
}

}  // namespace toccata
