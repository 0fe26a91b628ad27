#include "math/wide_integer.hpp"

#include <cmath>
#include <limits>

namespace toccata {
namespace {

/// The leading 64 bits of |v|, with the exponent of the last of them.
double rounded(const WideInteger& v, int exponent) {
  if (v == 0) return 0;
  const WideInteger magnitude = abs(v);
  const int dropped = std::max(static_cast<int>(msb(magnitude)) - 62, 0);
  const auto leading = WideInteger(magnitude >> static_cast<unsigned>(dropped)).convert_to<std::uint64_t>();
  const double value = std::ldexp(static_cast<double>(leading), dropped + exponent);
  return v < 0 ? -value : value;
}

}  // namespace

int common_exponent(std::span<const Vec3> points) {
  int least = std::numeric_limits<int>::max();
  for (const Vec3& point : points) least = std::min(least, common_exponent({point.x, point.y, point.z}));
  return least == std::numeric_limits<int>::max() ? 0 : least;
}

WideInteger scaled_wide(double value, int exponent) {
  const BinaryFraction f = binary_fraction(value);
  return f.mantissa == 0 ? WideInteger(0) : WideInteger(f.mantissa) << static_cast<unsigned>(f.exponent - exponent);
}

IntegerVector scaled_wide(const Vec3& point, int exponent) {
  return {{scaled_wide(point.x, exponent), scaled_wide(point.y, exponent), scaled_wide(point.z, exponent)}};
}

IntegerVector operator+(const IntegerVector& u, const IntegerVector& v) {
  return {{u[0] + v[0], u[1] + v[1], u[2] + v[2]}};
}

IntegerVector operator-(const IntegerVector& u, const IntegerVector& v) {
  return {{u[0] - v[0], u[1] - v[1], u[2] - v[2]}};
}

IntegerVector operator-(const IntegerVector& v) { return {{-v[0], -v[1], -v[2]}}; }

IntegerVector operator*(const WideInteger& s, const IntegerVector& v) { return {{s * v[0], s * v[1], s * v[2]}}; }

WideInteger dot(const IntegerVector& u, const IntegerVector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

IntegerVector cross(const IntegerVector& u, const IntegerVector& v) {
  return {{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}};
}

bool is_zero(const IntegerVector& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

Vec3 rounded_direction(const IntegerVector& v) {
  unsigned bits = 0;
  for (const WideInteger& c : v.along)
    if (c != 0) bits = std::max(bits, static_cast<unsigned>(msb(abs(c))));
  const int exponent = -static_cast<int>(bits) - 3;
  return {rounded(v[0], exponent), rounded(v[1], exponent), rounded(v[2], exponent)};
}

double nearest_double(const WideInteger& numerator, const WideInteger& denominator, int exponent) {
  return nearest_double(Integer(numerator), Integer(denominator), exponent);
}

}  // namespace toccata
