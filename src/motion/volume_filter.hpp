#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "math/filter.hpp"
#include "motion/moving_polygon.hpp"

// What doubles know of a moving polygon: the rounded differences that are its corners, and the volume that these span
// with the origin, a cubic in the time.
namespace toccata {

/// A corner at both ends of its way, each coordinate off by at most a factor 1 + 2^-53; infinite where it overflows.
struct RoundedCorner {
  Vec3 start;
  Vec3 end;
};

template <std::size_t Count>
using RoundedPolygon = std::array<RoundedCorner, Count>;

template <std::size_t Count>
RoundedPolygon<Count> rounded(const MovingPolygon<Count>& polygon) {
  RoundedPolygon<Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    const MovingCorner& c = polygon[i];
    result[i] = {c.head->start - c.tail->start, c.head->end - c.tail->end};
  }
  return result;
}

/// All corners stay strictly on one side of a plane through the origin along two axes. Exact, because the sign of a
/// difference survives its rounding; it says more than disjoint boxes of both ways do.
template <std::size_t Count>
bool is_apart_along(const RoundedPolygon<Count>& polygon, int axis) {
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (const RoundedCorner& c : polygon) {
    least = std::min(least, std::min(c.start[axis], c.end[axis]));
    greatest = std::max(greatest, std::max(c.start[axis], c.end[axis]));
  }
  return least > 0 || greatest < 0;
}

/// The cubic (q0 × q1) · q2 of three corners by its Bernstein coefficients: first, a third of the second and of the
/// third, and last. Those of the ends are off by at most `error`, those of the middle by three times that.
struct BernsteinVolume {
  double start = 0;
  double near_start = 0;  ///< three times the coefficient
  double near_end = 0;    ///< three times the coefficient
  double end = 0;
  double error = 0;

  /// A Bernstein polynomial lies between its least and its greatest coefficient. False for NaN.
  [[nodiscard]] bool is_certainly_not_zero() const {
    const double wide = 3 * error;
    return (start > error && near_start > wide && near_end > wide && end > error) ||
           (start < -error && near_start < -wide && near_end < -wide && end < -error);
  }
};

// The bound. As in filter.hpp let ε = 2^-53, η = 2^-1075, and let a rounded difference x̃ stand for x = x̃(1 + δ),
// |δ| ≤ ε. With q(0) = start and q(1) = end, and D(i, j, k) = (q0(i) × q1(j)) · q2(k), the polynomial's coefficients
// are
//     D(0,0,0),   [D(1,0,0) + D(0,1,0) + D(0,0,1)] / 3,   [D(1,1,0) + D(1,0,1) + D(0,1,1)] / 3,   D(1,1,1).
// Each D is six terms xyz. In three times a middle coefficient, a term meets three differences, a product, the
// difference of two products, the sum of two cross products, a product, two sums of the dot product and the last sum:
// ten factors 1 + δ. Let P be the sum of the six |x̃ỹz̃| where x̃, ỹ, z̃ are the greater of start and end, and W the sum
// of the |z̃|. Underflow takes η from each product: 2η from a coordinate of a cross product, 4η from one of the sum of
// two, which |z̃| multiplies, and 3η from each of two dot products. So three times a middle coefficient is off by at
// most
//     ((1 + ε)^10 − 1) 3P + 6.1η(W + 1) ≤ 10.1ε · 3P + 6.1η(W + 1),
// and the first and the last, with fewer factors and a third of the terms, by 10.1εP + 6.1η(W + 1).
// The magnitude M below takes at most eight roundings, and contains τ = `filter::floor` in each coordinate of the cross
// product and alone: M ≥ (1 − ε)^8 (2P + τ(W + 1)) − 10η ≥ 0.99 (2P + τ(W + 1)). So 8εM ≥ 15.8εP + 7ετ(W + 1) is more
// than either, because 7ετ = 7 · 2^22 η. That leaves 5εP for the comparisons: `error` is a power of two times M, and
// 3 · `error` is rounded once.
// M has twice the terms because then no rounded cross product, sum of two, or part of a dot product exceeds it: where
// one is infinite or NaN, M is too, and no comparison holds. Only the last sum of two finite numbers may still
// overflow, and then it has the right sign.
inline constexpr double moving_volume_bound = 0x1p-50;

inline Vec3 greatest_magnitudes(const RoundedCorner& c) {
  const auto greater = [](double a, double b) { return std::max(std::fabs(a), std::fabs(b)); };
  return {greater(c.start.x, c.end.x), greater(c.start.y, c.end.y), greater(c.start.z, c.end.z)};
}

inline BernsteinVolume bernstein_volume(const RoundedCorner& p, const RoundedCorner& q, const RoundedCorner& r) {
  const Vec3 first = cross(p.start, q.start), last = cross(p.end, q.end);
  const Vec3 mixed = cross(p.end, q.start) + cross(p.start, q.end);
  const Vec3 u = greatest_magnitudes(p), v = greatest_magnitudes(q), w = greatest_magnitudes(r);
  const double along_x = w.x * (2 * ((u.y * v.z + filter::floor) + u.z * v.y));
  const double along_y = w.y * (2 * ((u.z * v.x + filter::floor) + u.x * v.z));
  const double along_z = w.z * (2 * ((u.x * v.y + filter::floor) + u.y * v.x));
  const double magnitude = ((along_x + along_y) + along_z) + filter::floor;
  return {dot(first, r.start), dot(mixed, r.start) + dot(first, r.end), dot(last, r.start) + dot(mixed, r.end),
          dot(last, r.end), moving_volume_bound * magnitude};
}

}  // namespace toccata
