#pragma once

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

inline constexpr double radians_in_a_turn = 6.2831853071795865 * (1 + 0x1p-50);  ///< and a little more

/// A stretch of time in which no motion changes its piece.
struct TimeStretch {
  double begin = 0;
  double end = 1;
};

/// How the points of a body may move in a stretch, and how far doubles pose them from where they are.
struct MotionBounds {
  Vec3 velocity{};     ///< what all have in common, per unit of time
  double speed = 0;    ///< no point is faster beyond that
  double bending = 0;  ///< no second derivative of a point's place is longer; infinite where nothing is known
  double pad = 0;
};

/// The same of the gap of two points, one of each body, along a direction that rests (or, where one is a half-space, is
/// its normal).
struct GapBounds {
  double speed = 0;
  double bending = 0;
  double pad = 0;
};

[[nodiscard]] inline GapBounds gap_bounds(const MotionBounds& a, const MotionBounds& b) {
  return {length(a.velocity - b.velocity) + a.speed + b.speed, a.bending + b.bending, a.pad + b.pad};
}

/// How far points may leave the chord between their places at two times that are `step` apart, beyond the velocity that
/// all have in common: bending · step² / 8, or by the speed alone speed · step / 2, for from both ends they are within
/// speed · λ step and speed · (1 − λ) step of where the chord begins and ends. 2⁻³⁰ more covers the roundings.
[[nodiscard]] inline double farthest_from_chord(const MotionBounds& bounds, double step) {
  return std::min(0.125 * bounds.bending * step * step, 0.5 * bounds.speed * step) * (1 + 0x1p-30);
}

/// A bound of the least value, within a time `step`, of a function f with f(0) = start, f(step) = end, |f′| ≤ speed and
/// |f″| ≤ bending.
///
/// By the speed: f(t) is at least max(start − speed · t, end − speed · (step − t)), whose least value is
/// (start + end − speed · step) / 2. By the bending: f lies above the parabola through both ends with the second
/// derivative `bending`, for their difference is concave. With bow = bending · step² / 2 its vertex lies between the
/// ends when |end − start| < bow, at the height (start + end) / 2 − bow / 4 − (end − start)² / (4 bow); else it is
/// monotone. Both bounds are taken 2⁻³⁰ larger than they are and the result lessened by 8 u of what it was computed
/// from, which covers the roundings, at most six of relative size u.
[[nodiscard]] inline double least_between(double start, double end, double step, const GapBounds& bounds) {
  const double rise = std::fabs(end - start), ends = std::min(start, end);
  const double way = bounds.speed * step * (1 + 0x1p-30), bow = 0.5 * bounds.bending * step * step * (1 + 0x1p-30);
  if (rise >= bow || rise >= way) return ends;
  const double middle = 0.5 * (start + end);
  const double by_speed = middle - 0.5 * way;
  const double by_bending = bow < infinity ? middle - 0.25 * bow - 0.25 * rise * (rise / bow) : -infinity;
  const double rounded = 8 * unit_roundoff * (std::fabs(start) + std::fabs(end) + std::min(way, bow));
  return std::max(by_speed, by_bending) - rounded;
}

}  // namespace toccata
