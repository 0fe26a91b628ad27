#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/wide_integer.hpp"

// Polynomials in the time with integers as coefficients, and their real roots in [0, 1]: exact, without limits of size.
namespace toccata {

/// A polynomial of degree five at most, which the volume (3), a side of it (4) and their divisors stay below.
class IntegerPolynomial {
 public:
  static constexpr std::size_t capacity = 6;

  IntegerPolynomial() = default;
  /// start + (end − start) t
  IntegerPolynomial(const WideInteger& start, const WideInteger& end);

  [[nodiscard]] bool is_zero() const { return size_ == 0; }
  /// Coefficients, of 1, t, t², …; the last is not zero.
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const WideInteger& operator[](std::size_t power) const { return coefficients_[power]; }
  [[nodiscard]] const WideInteger& leading() const { return coefficients_[size_ - 1]; }

  friend IntegerPolynomial operator+(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend IntegerPolynomial operator-(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend IntegerPolynomial operator*(const IntegerPolynomial& a, const IntegerPolynomial& b);
  friend IntegerPolynomial derivative(const IntegerPolynomial& a);
  friend IntegerPolynomial remainder(IntegerPolynomial a, const IntegerPolynomial& b);
  friend IntegerPolynomial divided(IntegerPolynomial a, const WideInteger& divisor);
  friend IntegerPolynomial quotient(IntegerPolynomial a, const IntegerPolynomial& b);
  friend IntegerPolynomial primitive(IntegerPolynomial a);

 private:
  void trim();

  std::array<WideInteger, capacity> coefficients_;
  std::size_t size_ = 0;
};

/// A polynomial of greatest degree that divides both, up to a factor; neither is zero.
[[nodiscard]] IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b);

/// The same roots, each once, up to a factor; not of zero.
[[nodiscard]] IntegerPolynomial square_free(const IntegerPolynomial& a);

/// The times from index / 2^level to (index + 1) / 2^level.
struct DyadicCell {
  WideInteger index = 0;
  unsigned level = 0;

  [[nodiscard]] DyadicCell first_half() const { return {WideInteger(index << 1U), level + 1}; }
  [[nodiscard]] DyadicCell second_half() const { return {WideInteger((index << 1U) + 1), level + 1}; }
};

[[nodiscard]] Sign sign_at_start(const IntegerPolynomial& a, const DyadicCell& cell);

/// A real number: a cell's start, or the only root of a polynomial inside the cell.
struct PolynomialRoot {
  const IntegerPolynomial* polynomial = nullptr;  ///< changes its sign at the root; of a cell's start none is needed
  DyadicCell cell;
  bool is_start = false;
  Sign before = Sign::zero;  ///< of the polynomial, between the cell's start and the root

  /// Halves the cell, unless the root is its start.
  void narrow();
};

/// The roots of a polynomial in [0, 1], ascending. They refer to it, which is made square-free where it has roots that
/// lie too near to each other.
[[nodiscard]] std::vector<PolynomialRoot> roots_in_unit_interval(IntegerPolynomial& polynomial);

/// The exact sign of a polynomial at a root, whose cell it may narrow.
[[nodiscard]] Sign sign_at(const IntegerPolynomial& a, PolynomialRoot& root);

using PolynomialVector = std::array<IntegerPolynomial, 3>;

[[nodiscard]] PolynomialVector operator-(const PolynomialVector& u, const PolynomialVector& v);
[[nodiscard]] IntegerPolynomial dot(const PolynomialVector& u, const PolynomialVector& v);
[[nodiscard]] PolynomialVector cross(const PolynomialVector& u, const PolynomialVector& v);

}  // namespace toccata
