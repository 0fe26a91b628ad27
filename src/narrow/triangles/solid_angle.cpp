#include "narrow/triangles/solid_angle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "math/double_word.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

constexpr double turns_per_radian = 0x1.45f306dc9c883p-3;

/// For t from 0 to 1: by the tangent's addition theorem from the nearest eighth, and the series there.
double radians_of_tangent(double t) {
  constexpr std::array<double, 9> at_eighths{0,
                                             0.12435499454676143503,
                                             0.24497866312686415417,
                                             0.35877067027057222040,
                                             0.46364760900080611621,
                                             0.55859931534356243597,
                                             0.64350110879328438680,
                                             0.71882999962162450542,
                                             0.78539816339744830962};
  const double eighths = std::floor(8 * t + 0.5), nearest = 0.125 * eighths;
  const double r = (t - nearest) / (1 + t * nearest), s = r * r;
  double tail = 0;
  for (const double term : {-1.0 / 15, 1.0 / 13, -1.0 / 11, 1.0 / 9, -1.0 / 7, 1.0 / 5, -1.0 / 3})
    tail = term + s * tail;
  return at_eighths[static_cast<std::size_t>(eighths)] + (r + r * s * tail);
}

/// A vector of doubles, or of pairs of such.
template <class Number>
struct Direction {
  Number x{};
  Number y{};
  Number z{};
};

template <class Number>
Number product(const Direction<Number>& a, const Direction<Number>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

double root(double a) { return std::sqrt(a); }

/// One step after Newton.
DoubleWord root(const DoubleWord& a) {
  const double near = std::sqrt(a.high);
  if (near == 0) return {};
  const DoubleWord rest = a - double_word(two_product(near, near));
  return double_word(fast_two_sum(near, rest.high / (2 * near)));
}

double high_part(double a) { return a; }
double high_part(const DoubleWord& a) { return a.high; }

/// The tangent of half the solid angle is volume / rest; both are at most 4 · size in magnitude.
struct HalfAngle {
  double volume;
  double rest;
  double size;
};

template <class Number>
HalfAngle half_angle(const std::array<Direction<Number>, 3>& corner) {
  const auto& [a, b, c] = corner;
  const Number of_a = root(product(a, a)), of_b = root(product(b, b)), of_c = root(product(c, c));
  const Number size = of_a * of_b * of_c;
  const Number volume = (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z)) + a.z * (b.x * c.y - b.y * c.x);
  const Number rest = (size + product(a, b) * of_c) + (product(b, c) * of_a + product(c, a) * of_b);
  return {high_part(volume), high_part(rest), high_part(size)};
}

/// From the point to a corner, exactly: the high parts are what doubles make of it.
Direction<DoubleWord> direction_to(const Vec3& corner, const Vec3& point) {
  return {exact_difference(corner.x, point.x), exact_difference(corner.y, point.y),
          exact_difference(corner.z, point.z)};
}

double greatest_of(const Direction<DoubleWord>& d) {
  return std::max({std::abs(d.x.high), std::abs(d.y.high), std::abs(d.z.high)});
}

/// The direction scaled to a size near 1: solid angles see directions alone.
Direction<DoubleWord> near_unit(const Direction<DoubleWord>& d) {
  const int exponent = -std::ilogb(greatest_of(d));
  const auto scaled = [exponent](const DoubleWord& x) {
    return DoubleWord{std::scalbn(x.high, exponent), std::scalbn(x.low, exponent)};
  };
  return {scaled(d.x), scaled(d.y), scaled(d.z)};
}

bool is_plain(const Direction<DoubleWord>& d) {
  const double greatest = greatest_of(d);
  return greatest > 0x1p-150 && greatest < 0x1p150;
}

/// What the volume and the rest are off by, as a part of the size.
constexpr double off_in_doubles = 0x1p-47, off_in_pairs = 0x1p-92;

/// Precondition: the volume has the right sign or is 0, and then `sign` is that of the exact one.
SolidAngle certified(HalfAngle half, double off_by, Sign sign) {
  double off = off_by * half.size;
  if (half.volume == 0) {
    half.volume = std::copysign(0.0, sign == Sign::positive ? 1.0 : -1.0);
    off *= 2;
  }
  const double length = std::sqrt(half.volume * half.volume + half.rest * half.rest);
  // Up to half the length, the arc's sine is at most 1.05 times the sine.
  if (!(off < 0.5 * length)) return {std::copysign(0.25, half.volume), 0.25};
  return {turns_of(half.volume, half.rest), 1.06 * turns_per_radian * (off / length) + 0x1p-51};
}

/// The sign that the solid angle has: positive where the point lies behind.
Sign sign_of_angle(const Vec3& point, const Triangle& t) { return -orient3d(t[0], t[1], t[2], point); }

}  // namespace

double turns_of(double y, double x) {
  const double size_x = std::abs(x), size_y = std::abs(y);
  const bool steep = size_y > size_x;
  double radians = radians_of_tangent(steep ? size_x / size_y : size_y / size_x);
  constexpr double half_pi = 1.57079632679489661923, pi = 3.14159265358979323846;
  if (steep) radians = half_pi - radians;
  if (x < 0) radians = pi - radians;
  return std::copysign(radians * turns_per_radian, y);
}

SolidAngle solid_angle(const Vec3& point, const Triangle& triangle) {
  std::array<Direction<DoubleWord>, 3> corner;
  bool plain = true;
  for (std::size_t i = 0; i < 3; ++i) {
    corner[i] = direction_to(triangle[static_cast<int>(i)], point);
    plain = plain && is_plain(corner[i]);
  }
  if (!plain) {
    for (std::size_t i = 0; i < 3; ++i) {
      // A quarter is enough for no difference to overflow.
      if (!std::isfinite(greatest_of(corner[i])))
        corner[i] = direction_to(0.25 * triangle[static_cast<int>(i)], 0.25 * point);
      if (greatest_of(corner[i]) == 0) return {};
      corner[i] = near_unit(corner[i]);
    }
  }
  std::array<Direction<double>, 3> rounded;
  for (std::size_t i = 0; i < 3; ++i) rounded[i] = {corner[i].x.high, corner[i].y.high, corner[i].z.high};

  constexpr double good_enough = 0x1p-40;
  HalfAngle half = half_angle(rounded);
  Sign sign = Sign::positive;
  if (!(std::abs(half.volume) > off_in_doubles * half.size)) {
    sign = sign_of_angle(point, triangle);
    if (sign == Sign::zero) return {};
    half.volume = 0;
  }
  const SolidAngle quick = certified(half, off_in_doubles, sign);
  if (quick.bound <= good_enough) return quick;
  half = half_angle(corner);
  if (!(std::abs(half.volume) > off_in_pairs * half.size)) {
    sign = sign_of_angle(point, triangle);
    if (sign == Sign::zero) return {};
    half.volume = 0;
  }
  return certified(half, off_in_pairs, sign);
}

}  // namespace toccata
