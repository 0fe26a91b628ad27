#pragma once

#include <algorithm>
#include <cmath>

#include "math/bounded_double.hpp"
#include "math/constants.hpp"
#include "toccata/bounds/aabb.hpp"

namespace toccata {

/// The exact volume lies between these.
struct VolumeBracket {
  double lower = 0;
  double upper = 0;
};

/// Not negative; infinite where no double tells how much.
[[nodiscard]] inline VolumeBracket volume_bracket_of(const BoundedNumber& volume) {
  const double lower = floor_of(volume), upper = ceiling_of(volume);
  return {std::isfinite(lower) ? std::max(lower, 0.0) : 0, upper >= 0 ? upper : std::isnan(upper) ? infinity : 0};
}

/// The volume of a box.
[[nodiscard]] inline BoundedNumber bounded_volume(const Aabb& box) {
  return bounded_difference(box.upper.x, box.lower.x) * bounded_difference(box.upper.y, box.lower.y) *
         bounded_difference(box.upper.z, box.lower.z);
}

/// Both hold.
[[nodiscard]] inline VolumeBracket narrower(const VolumeBracket& a, const VolumeBracket& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

}  // namespace toccata
