#include "math/scaled_integer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace toccata {

BinaryFraction binary_fraction(double value) {
  if (value == 0) return {};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);  // in [1/2, 1), denormals included
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

Integer determinant(const IntegerRow& u, const IntegerRow& v, const IntegerRow& w) {
  const auto minor = [&](std::size_t i, std::size_t j) { return Integer(u[i] * v[j] - u[j] * v[i]); };
  return minor(1, 2) * w[0] + minor(2, 0) * w[1] + minor(0, 1) * w[2];
}

int common_exponent(std::initializer_list<double> values) {
  int least = std::numeric_limits<int>::max();
  for (const double value : values)
    if (value != 0) least = std::min(least, binary_fraction(value).exponent);
  return least;
}

Integer scaled(double value, int exponent) {
  const BinaryFraction f = binary_fraction(value);
  return f.mantissa == 0 ? Integer(0) : Integer(f.mantissa) << static_cast<unsigned>(f.exponent - exponent);
}

}  // namespace toccata
