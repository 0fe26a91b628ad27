#include "query/decomposition/cut_plane.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

RationalPoint exact_normal(const PlaneChoice& choice) {
  if (!choice.of_points) return to_rational(choice.normal);
  const RationalPoint a = to_rational(choice.through);
  return cross(to_rational(choice.others[0]) - a, to_rational(choice.others[1]) - a);
}

/// Scaled by a power of two so that its greatest component is about 1: signs stay, and nothing under- or overflows.
RationalPoint scaled_to_one(const RationalPoint& normal) {
  Rational most = 0;
  for (int axis = 0; axis < 3; ++axis) most = std::max<Rational>(most, abs(normal[axis]));
  if (most == 0) return normal;
  const int exponent = static_cast<int>(msb(numerator(most))) - static_cast<int>(msb(denominator(most)));
  const auto shift = static_cast<unsigned>(std::abs(exponent));
  const Rational power(Integer(1) << shift);
  return (exponent > 0 ? Rational(1) / power : power) * normal;
}

}  // namespace

CutPlane::CutPlane(const PlaneChoice& choice)
    : choice_(choice),
      normal_(scaled_to_one(exact_normal(choice))),
      offset_(dot(normal_, to_rational(choice.through))),
      rounded_normal_(nearest_doubles(normal_)) {}

Sign CutPlane::side(const Vec3& point) const {
  // Per term: the normal, the difference and the product are off by 2^-53 each, and two sums follow. The floor stands
  // for what underflow loses.
  const Vec3 way = point - choice_.through;
  const double x = rounded_normal_.x * way.x, y = rounded_normal_.y * way.y, z = rounded_normal_.z * way.z;
  const double height = (x + y) + z;
  const double error = 0x1p-49 * ((std::fabs(x) + std::fabs(y)) + std::fabs(z)) + 0x1p-1000;
  if (height > error) return Sign::positive;
  if (height < -error) return Sign::negative;
  return side(to_rational(point));
}

}  // namespace toccata
