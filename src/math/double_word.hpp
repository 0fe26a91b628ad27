#pragma once

#include "math/expansion.hpp"

// Numbers of about 106 bits: the unevaluated sum of a double and what it is off by (M. Joldes, J.-M. Muller,
// V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", 2017). Each
// operation is off by at most 15u² + 56u³ relative to its result, where u = 2^-53; less than `double_word_bound`, as
// long as nothing under- or overflows.
namespace toccata {

inline constexpr double double_word_bound = 0x1p-102;

/// |low| is at most half a unit in the last place of high.
struct DoubleWord {
  double high = 0;
  double low = 0;
};

inline DoubleWord double_word(const TwoPart& parts) { return {parts.high, parts.low}; }

/// a − b, exactly.
inline DoubleWord exact_difference(double a, double b) { return double_word(two_difference(a, b)); }

inline DoubleWord operator-(const DoubleWord& a) { return {-a.high, -a.low}; }

/// Their algorithm 6.
inline DoubleWord operator+(const DoubleWord& a, const DoubleWord& b) {
  const TwoPart high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const TwoPart carried = fast_two_sum(high.high, high.low + low.high);
  return double_word(fast_two_sum(carried.high, low.low + carried.low));
}

inline DoubleWord operator-(const DoubleWord& a, const DoubleWord& b) { return a + -b; }

/// Their algorithm 10.
inline DoubleWord operator*(const DoubleWord& a, const DoubleWord& b) {
  const TwoPart product = two_product(a.high, b.high);
  return double_word(fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high)));
}

inline DoubleWord operator*(const DoubleWord& a, double b) {
  const TwoPart product = two_product(a.high, b);
  const TwoPart high = fast_two_sum(product.high, a.low * b);
  return double_word(fast_two_sum(high.high, high.low + product.low));
}

/// Their algorithm 17.
inline DoubleWord operator/(const DoubleWord& a, const DoubleWord& b) {
  const double quotient = a.high / b.high;
  const DoubleWord back = b * quotient;
  const double rest = (a.high - back.high) + (a.low - back.low);
  return double_word(fast_two_sum(quotient, rest / b.high));
}

}  // namespace toccata
