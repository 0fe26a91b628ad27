#pragma once

#include <algorithm>
#include <initializer_list>

#include "math/wide_integer.hpp"
#include "toccata/math/predicates.hpp"

// What the kinds of quadrics are described with.
namespace toccata {

/// How far a shape reaches from its middle along a direction and against it.
struct QuadricReach {
  double down = 0;
  double up = 0;
};

/// The point of a shape around an axis that is nearest to a point outside, in the half plane from the axis through that
/// point: `out` from the axis, `up` along it from the middle. Its derivative by the point is, in the directions across
/// the half plane and within it, `share` and the projection onto the vector (slope_out, slope_up).
struct AxialFoot {
  double out = 0;
  double up = 0;
  double share = 0;
  double slope_out = 0;
  double slope_up = 0;
  bool outside = true;  ///< else nothing else is told
};

/// The sign of a − √b, where b is not negative.
inline Sign sign_of_less_root(const WideInteger& a, const WideInteger& b) {
  return a < 0 ? Sign::negative : sign_of(a * a - b);
}

/// The greatest sign of numbers that are positive outside.
inline Sign greatest_sign(std::initializer_list<WideInteger> numbers) {
  Sign greatest = Sign::negative;
  for (const WideInteger& number : numbers) greatest = std::max(greatest, sign_of(number));
  return greatest;
}

}  // namespace toccata
