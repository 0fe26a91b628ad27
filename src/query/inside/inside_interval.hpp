#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/constants.hpp"

namespace toccata {

/// Closed interval of doubles that contains an exact value; every operation rounds outward, and what overflows becomes
/// the whole line. Only a filter: its callers fall back on rational numbers where it does not settle a sign.
struct Interval {
  double lower = 0;
  double upper = 0;
};

namespace interval_rounding {

// An operation is off by at most half a unit in the last place, which is less than |x|·2^-52, or by less than the least
// positive double where it underflows.
inline double slack(double x) { return std::abs(x) * 0x1p-52 + std::numeric_limits<double>::denorm_min(); }

inline Interval outward(double lower, double upper) {
  const Interval widened{lower - slack(lower), upper + slack(upper)};
  if (std::isfinite(widened.lower) && std::isfinite(widened.upper)) return widened;
  return {-infinity, infinity};
}

}  // namespace interval_rounding

inline Interval operator+(const Interval& a, const Interval& b) {
  return interval_rounding::outward(a.lower + b.lower, a.upper + b.upper);
}

inline Interval operator-(const Interval& a, const Interval& b) {
  return interval_rounding::outward(a.lower - b.upper, a.upper - b.lower);
}

inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.lower * b.lower, q = a.lower * b.upper, r = a.upper * b.lower, s = a.upper * b.upper;
  return interval_rounding::outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}

/// The whole line unless the divisor is certainly positive.
inline Interval operator/(const Interval& a, const Interval& b) {
  if (!(b.lower > 0)) return {-infinity, infinity};
  const double p = a.lower / b.lower, q = a.lower / b.upper, r = a.upper / b.lower, s = a.upper / b.upper;
  return interval_rounding::outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}

/// False also when a side is not a number.
inline bool certainly_positive(const Interval& a) { return a.lower > 0; }
inline bool certainly_negative(const Interval& a) { return a.upper < 0; }
inline bool certainly_less(const Interval& a, const Interval& b) { return a.upper < b.lower; }

}  // namespace toccata
