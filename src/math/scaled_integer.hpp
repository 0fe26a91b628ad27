#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>

#include "math/exact.hpp"

namespace toccata {

/// mantissa · 2^exponent, with an odd mantissa, or 0 · 2^0.
struct BinaryFraction {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

/// A finite double, taken apart; exponents lie in [-1074, 1023].
[[nodiscard]] BinaryFraction binary_fraction(double value);

/// The least exponent among the values: over it all of them are integers. Zeros have none.
[[nodiscard]] int common_exponent(std::initializer_list<double> values);

/// value / 2^exponent, which must be whole.
[[nodiscard]] Integer scaled(double value, int exponent);

/// One row of a matrix of integers.
using IntegerRow = std::array<Integer, 3>;

[[nodiscard]] Integer determinant(const IntegerRow& u, const IntegerRow& v, const IntegerRow& w);

}  // namespace toccata
