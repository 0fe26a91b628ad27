#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/upper_sum.hpp"
#include "math/constants.hpp"
#include "toccata/bounds/aabb.hpp"

// The bounds of volume.hpp for two boxes that may have no end, by a handful of operations. No coordinate is NaN.
namespace toccata {

/// The length of a vector of non-negative lengths, +∞ among them: what arithmetic without least and greatest numbers
/// makes of it, so that it never shrinks where one of them grows. At most the greatest double.
inline double monotone_length(const Vec3& v) {
  constexpr double most = std::numeric_limits<double>::max();
  const auto root = [](const Vec3& w) { return std::sqrt((w.x * w.x + w.y * w.y) + w.z * w.z); };
  const double size = largest_magnitude(v);
  if (size > 0x1p-400 && size < 0x1p400) return root(v);
  if (size == 0 || size > most) return size == 0 ? 0 : most;
  const int exponent = std::ilogb(size);
  const auto scaled = [exponent](double x) { return std::scalbn(x, -exponent); };
  return std::min(std::scalbn(root({scaled(v.x), scaled(v.y), scaled(v.z)}), exponent), most);
}

/// No point of a, which is not empty, is nearer to one of b; +∞ when b is empty. It never shrinks with b.
inline double box_gap(const Aabb& a, const Aabb& b) {
  if (is_empty(b)) return infinity;
  const auto beside = [&](int axis) {
    return std::max({0.0, b.lower[axis] - a.upper[axis], a.lower[axis] - b.upper[axis]});
  };
  return rounded_down(monotone_length({beside(0), beside(1), beside(2)}));
}

/// a, which is not empty, moved by t · motion, does not meet b before this t ≥ 0; +∞: not until it has gone all the
/// way, t = 1. The motion is finite. It never shrinks with b.
inline double box_entry(const Aabb& a, const Vec3& motion, const Aabb& b) {
  constexpr double never = infinity;
  if (is_empty(b)) return never;
  double first = 0, last = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double ahead = b.lower[axis] - a.upper[axis], behind = b.upper[axis] - a.lower[axis];
    if (motion[axis] == 0) {
      if (ahead > 0 || behind < 0) return never;
      continue;
    }
    // A difference that overflows is longer than every motion, as is the quotient that it makes.
    const bool forward = motion[axis] > 0;
    const double in = (forward ? ahead : behind) / motion[axis], out = (forward ? behind : ahead) / motion[axis];
    // Two roundings each, and what is below the range.
    first = std::max(first, in * (1 - 0x1p-50) - 0x1p-1060);
    last = std::min(last, out * (1 + 0x1p-50) + 0x1p-1060);
  }
  return first <= last ? first : never;
}

}  // namespace toccata
