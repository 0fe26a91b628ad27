#pragma once

#include <array>
#include <cmath>

#include "math/bounded_number.hpp"

namespace toccata {

/// What BoundedNumber is, with 53 bits: the exact number lies within 2 · error of `value`. The proof is the same, with
/// 2⁻⁵³ for what an operation rounds.
struct BoundedDouble {
  double value = 0;
  double error = 0;

  [[nodiscard]] double reach() const { return 2 * error; }
  [[nodiscard]] bool is_positive() const { return value > 4 * error; }
  [[nodiscard]] bool is_negative() const { return value < -4 * error; }
};

inline BoundedDouble operator-(const BoundedDouble& a) { return {-a.value, a.error}; }

inline BoundedDouble operator+(const BoundedDouble& a, const BoundedDouble& b) {
  const double sum = a.value + b.value;
  return {sum, (a.error + b.error) + 0x1p-53 * std::fabs(sum)};
}

inline BoundedDouble operator-(const BoundedDouble& a, const BoundedDouble& b) { return a + -b; }

inline BoundedDouble operator*(const BoundedDouble& a, const BoundedDouble& b) {
  const double product = a.value * b.value;
  const double propagated = (std::fabs(a.value) + 2 * a.error) * b.error + std::fabs(b.value) * a.error;
  return {product, propagated + (0x1p-53 * std::fabs(product) + BoundedNumber::underflow)};
}

/// The quotient is not certain (an infinite bound) unless the divisor's sign is.
inline BoundedDouble operator/(const BoundedDouble& a, const BoundedDouble& b) {
  if (!(b.is_positive() || b.is_negative())) return {0, HUGE_VAL};
  const double quotient = a.value / b.value;
  // |b| is at least half of what it is taken to be.
  const double propagated = (a.error + std::fabs(quotient) * b.error) + BoundedNumber::underflow;
  return {quotient, 2 * (propagated / std::fabs(b.value)) + (0x1p-53 * std::fabs(quotient) + BoundedNumber::underflow)};
}

/// The root is not certain unless the number is certainly positive.
inline BoundedDouble square_root(const BoundedDouble& a) {
  if (!a.is_positive()) return {0, HUGE_VAL};
  const double root = std::sqrt(a.value);
  // A root of at least half the number is at least 0.7 of its root.
  return {root, (a.error + BoundedNumber::underflow) / root + 0x1p-53 * root};
}

inline double middle(const BoundedNumber& a) { return a.value.high; }
inline double middle(const BoundedDouble& a) { return a.value; }

/// No greater than the exact number.
inline double floor_of(const BoundedNumber& a) {
  return std::nextafter(a.value.high - distance_from_high(a), -HUGE_VAL);
}
inline double floor_of(const BoundedDouble& a) { return std::nextafter(a.value - 4 * a.error, -HUGE_VAL); }

/// No less than the exact number.
inline double ceiling_of(const BoundedNumber& a) { return -floor_of(-a); }
inline double ceiling_of(const BoundedDouble& a) { return -floor_of(-a); }

/// The root of a sum of squares, which is not negative whatever its bound says.
template <class Number>
Number root_of_squares(const Number& a) {
  if (a.is_positive()) return square_root(a);
  Number root;
  // The exact root lies between 0 and this.
  root.error = std::sqrt(2 * (std::fabs(middle(a)) + 2 * a.error));
  return root;
}

}  // namespace toccata
