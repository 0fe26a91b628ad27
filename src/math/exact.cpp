#include "math/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "math/scaled_integer.hpp"

namespace toccata {
namespace {

constexpr int lowest_exponent = -1074;  // of the least positive double

unsigned as_shift(int count) { return static_cast<unsigned>(count); }

/// The largest e with 2^e ≤ n / d, for positive n and d.
int floor_log2(const Integer& n, const Integer& d) {
  const int e = static_cast<int>(msb(n)) - static_cast<int>(msb(d));
  const bool reached = e >= 0 ? n >= (d << as_shift(e)) : (n << as_shift(-e)) >= d;
  return reached ? e : e - 1;
}

/// n / d to the nearest integer, ties to even, for n ≥ 0 and d > 0.
Integer divide_to_nearest(const Integer& n, const Integer& d) {
  Integer quotient, remainder;
  divide_qr(n, d, quotient, remainder);
  const int half = Integer(remainder << 1).compare(d);
  if (half > 0 || (half == 0 && bit_test(quotient, 0))) ++quotient;
  return quotient;
}

double nearest_positive(const Integer& n, const Integer& d) {
  const int e = floor_log2(n, d);
  if (e > 1023) return HUGE_VAL;
  // One unit of the result; below the normal range it no longer shrinks with the value.
  const int unit = std::max(e - 52, lowest_exponent);
  const Integer mantissa =
      unit >= 0 ? divide_to_nearest(n, d << as_shift(unit)) : divide_to_nearest(n << as_shift(-unit), d);
  return std::ldexp(static_cast<double>(mantissa.convert_to<std::int64_t>()), unit);  // exact: at most 2^53 units
}

/// A rational point over one positive denominator w, so that determinants need no division.
struct HomogeneousPoint {
  std::array<Integer, 3> numerator;
  Integer w;
};

HomogeneousPoint homogeneous(const Rational& x, const Rational& y, const Rational& z) {
  const Integer w = lcm(lcm(denominator(x), denominator(y)), denominator(z));
  const auto over_w = [&](const Rational& r) { return Integer(numerator(r) * (w / denominator(r))); };
  return {{over_w(x), over_w(y), over_w(z)}, w};
}

/// A positive multiple of p − q.
IntegerRow difference(const HomogeneousPoint& p, const HomogeneousPoint& q) {
  const auto along = [&](std::size_t i) { return Integer(p.numerator[i] * q.w - q.numerator[i] * p.w); };
  return {along(0), along(1), along(2)};
}

}  // namespace

Rational to_rational(double value) {
  const BinaryFraction f = binary_fraction(value);
  if (f.exponent >= 0) return Rational(Integer(f.mantissa) << as_shift(f.exponent));
  return Rational(Integer(f.mantissa), Integer(1) << as_shift(-f.exponent));
}

double nearest_double(const Rational& value) { return nearest_double(numerator(value), denominator(value), 0); }

double nearest_double(const Integer& n, const Integer& d, int exponent) {
  if (n == 0) return 0;
  const double magnitude = exponent >= 0 ? nearest_positive(abs(n) << as_shift(exponent), d)
                                         : nearest_positive(abs(n), d << as_shift(-exponent));
  if (magnitude == 0) return 0;
  return n < 0 ? -magnitude : magnitude;
}

Sign sign_of(const Integer& value) { return static_cast<Sign>(value.sign()); }
Sign sign_of(const Rational& value) { return static_cast<Sign>(value.sign()); }

RationalPoint2 to_rational(const Vec2& p) { return {to_rational(p.x), to_rational(p.y)}; }
RationalPoint to_rational(const Vec3& p) { return {to_rational(p.x), to_rational(p.y), to_rational(p.z)}; }

Vec3 nearest_doubles(const RationalPoint& p) { return {nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)}; }

RationalPoint operator+(const RationalPoint& a, const RationalPoint& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
RationalPoint operator-(const RationalPoint& a, const RationalPoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RationalPoint operator*(const Rational& s, const RationalPoint& a) { return {s * a.x, s * a.y, s * a.z}; }

Rational dot(const RationalPoint& a, const RationalPoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

RationalPoint2 drop_axis(const RationalPoint& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
  const HomogeneousPoint origin = homogeneous(a.x, a.y, 0);
  const IntegerRow u = difference(homogeneous(b.x, b.y, 0), origin), v = difference(homogeneous(c.x, c.y, 0), origin);
  return sign_of(Integer(u[0] * v[1] - u[1] * v[0]));
}

Sign orient3d(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
  const HomogeneousPoint origin = homogeneous(a.x, a.y, a.z);
  const auto from_origin = [&](const RationalPoint& p) { return difference(homogeneous(p.x, p.y, p.z), origin); };
  return sign_of(determinant(from_origin(b), from_origin(c), from_origin(d)));
}

}  // namespace toccata
