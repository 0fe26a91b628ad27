#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "math/double_word.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// A number of about 106 bits with a bound on what it is off by, carried along: the exact number lies within
/// 2 · error of `value`. Under- and overflow are part of the bound, the latter as NaN or infinity; so every comparison
/// below is asked such that NaN means "not certain".
///
/// The proof: an operation adds what its operands are off by, propagated to first and second order, its own error of
/// `double_word_bound`, and `underflow` for the parts of products that are lost below the range (each of the dozen
/// operations in a product loses at most 2^-1074). Computing the bound rounds less than a thousand times in any
/// formula here, each time by a factor of at least 1 − 2^-53; the factor 2 in reading it covers that.
struct BoundedNumber {
  DoubleWord value;
  double error = 0;

  static constexpr double underflow = 0x1p-1060;

  [[nodiscard]] double reach() const { return 2 * error; }
  [[nodiscard]] bool is_positive() const { return value.high > 4 * error; }
  [[nodiscard]] bool is_negative() const { return value.high < -4 * error; }
};

inline BoundedNumber exactly(double value) { return {{value, 0}, 0}; }
inline BoundedNumber bounded_difference(double a, double b) { return {exact_difference(a, b), 0}; }

inline BoundedNumber operator-(const BoundedNumber& a) { return {-a.value, a.error}; }

inline BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b) {
  const DoubleWord sum = a.value + b.value;
  const bool is_exact = a.value.low == 0 && b.value.low == 0;  // two doubles
  return {sum, (a.error + b.error) + (is_exact ? 0 : double_word_bound * std::fabs(sum.high))};
}

inline BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b) { return a + -b; }

inline BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b) {
  const DoubleWord product = a.value * b.value;
  const double propagated = (std::fabs(a.value.high) + a.error) * b.error + std::fabs(b.value.high) * a.error;
  return {product, 1.5 * propagated + (double_word_bound * std::fabs(product.high) + BoundedNumber::underflow)};
}

/// The quotient is not certain (an infinite bound) unless the divisor's sign is.
inline BoundedNumber operator/(const BoundedNumber& a, const BoundedNumber& b) {
  if (!(b.is_positive() || b.is_negative())) return {{0, 0}, HUGE_VAL};
  const DoubleWord quotient = a.value / b.value;
  // |b| is at least half of what it is taken to be.
  const double propagated = (a.error + std::fabs(quotient.high) * b.error) + BoundedNumber::underflow;
  return {quotient, 4 * (propagated / std::fabs(b.value.high)) +
                        (2 * double_word_bound * std::fabs(quotient.high) + BoundedNumber::underflow)};
}

/// The square root, by a step of Newton's method from the root of the high part. Not certain unless the number is
/// certainly positive.
inline BoundedNumber square_root(const BoundedNumber& a) {
  if (!a.is_positive()) return {{0, 0}, HUGE_VAL};
  const double root = std::sqrt(a.value.high);
  const DoubleWord rest = a.value - double_word(two_product(root, root));
  const DoubleWord refined = double_word(fast_two_sum(root, rest.high / (2 * root)));
  // The step leaves rest² / (8 root³), less than 2^-104 of the root, and rounds its correction, as much again.
  return {refined, (a.error + BoundedNumber::underflow) / root + 4 * double_word_bound * root};
}

using BoundedVector = std::array<BoundedNumber, 3>;

inline BoundedVector bounded_difference(const Vec3& a, const Vec3& b) {
  return {bounded_difference(a.x, b.x), bounded_difference(a.y, b.y), bounded_difference(a.z, b.z)};
}
inline BoundedVector exactly(const Vec3& a) { return {exactly(a.x), exactly(a.y), exactly(a.z)}; }

inline BoundedVector operator+(const BoundedVector& u, const BoundedVector& v) {
  return {u[0] + v[0], u[1] + v[1], u[2] + v[2]};
}
inline BoundedVector operator-(const BoundedVector& u, const BoundedVector& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}
inline BoundedVector operator*(const BoundedNumber& s, const BoundedVector& v) {
  return {s * v[0], s * v[1], s * v[2]};
}
inline BoundedNumber dot(const BoundedVector& u, const BoundedVector& v) {
  return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2];
}
inline BoundedVector cross(const BoundedVector& u, const BoundedVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

inline bool is_exactly_zero(const BoundedNumber& a) { return a.value.high == 0 && a.error == 0; }

/// The length of a vector; exact along an axis.
inline BoundedNumber length(const BoundedVector& v) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (is_exactly_zero(v[(axis + 1) % 3]) && is_exactly_zero(v[(axis + 2) % 3]))
      return v[axis].value.high < 0 ? -v[axis] : v[axis];
  return square_root(dot(v, v));
}

inline Vec3 high_parts(const BoundedVector& v) { return {v[0].value.high, v[1].value.high, v[2].value.high}; }

/// What the exact number may differ by from the high part of a bounded one; more than that by a little.
inline double distance_from_high(const BoundedNumber& a) { return 1.0001 * std::fabs(a.value.low) + 4 * a.error; }

/// The greatest double that is at most a number and the least that is at least; equal when the number is a double.
struct DoubleBracket {
  double lower = 0;
  double upper = 0;
};

/// That of the exact number, which is positive, if it is certain.
inline std::optional<DoubleBracket> bracket(const BoundedNumber& a) {
  const double high = a.value.high, low = a.value.low, off = 4 * a.error;
  if (low > off) return DoubleBracket{high, std::nextafter(high, HUGE_VAL)};
  if (low < -off) return DoubleBracket{std::nextafter(high, 0), high};
  if (low == 0 && a.error == 0) return DoubleBracket{high, high};
  return {};
}

/// The double nearest to the exact number, if that is certain; a tie never is.
inline std::optional<double> nearest_double(const BoundedNumber& a) {
  const double off = distance_from_high(a), high = a.value.high;
  // Rounding is monotone: what lies between two numbers that round to `high` rounds to it too.
  if (high + off == high && high - off == high) return high == 0 ? 0.0 : high;
  return {};
}

inline std::optional<Vec3> nearest_doubles(const BoundedVector& v) {
  const auto x = nearest_double(v[0]), y = nearest_double(v[1]), z = nearest_double(v[2]);
  if (!x || !y || !z) return {};
  return Vec3{*x, *y, *z};
}

}  // namespace toccata
