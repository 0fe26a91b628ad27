#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "math/scaled_integer.hpp"

namespace toccata {

/// An integer of any size that allocates no memory up to 1024 bits.
using WideInteger =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<1024>, boost::multiprecision::et_off>;

/// A point or vector over a common unit that is kept elsewhere.
struct IntegerVector {
  std::array<WideInteger, 3> along;

  const WideInteger& operator[](std::size_t axis) const { return along[axis]; }
  WideInteger& operator[](std::size_t axis) { return along[axis]; }
};

/// What 2^unit divides all coordinates of all points. Zeros are divided by anything.
[[nodiscard]] int common_exponent(std::span<const Vec3> points);

/// value / 2^exponent, which must be whole.
[[nodiscard]] WideInteger scaled_wide(double value, int exponent);
[[nodiscard]] IntegerVector scaled_wide(const Vec3& point, int exponent);

[[nodiscard]] IntegerVector operator+(const IntegerVector& u, const IntegerVector& v);
[[nodiscard]] IntegerVector operator-(const IntegerVector& u, const IntegerVector& v);
[[nodiscard]] IntegerVector operator-(const IntegerVector& v);
[[nodiscard]] IntegerVector operator*(const WideInteger& s, const IntegerVector& v);
[[nodiscard]] WideInteger dot(const IntegerVector& u, const IntegerVector& v);
[[nodiscard]] IntegerVector cross(const IntegerVector& u, const IntegerVector& v);
[[nodiscard]] bool is_zero(const IntegerVector& v);

[[nodiscard]] inline Sign sign_of(const WideInteger& value) { return static_cast<Sign>(value.sign()); }

/// A vector of nearly the same direction: the greatest coordinate is at most 1/4 in magnitude and at least 1/16, and
/// each is off by at most 2^-53 of itself or by 2^-1074. Not for the zero vector.
[[nodiscard]] Vec3 rounded_direction(const IntegerVector& v);

/// The same as for Integer (math/exact.hpp).
[[nodiscard]] double nearest_double(const WideInteger& numerator, const WideInteger& denominator, int exponent);

}  // namespace toccata
