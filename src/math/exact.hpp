#pragma once

#include "math/rational.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/math/vec3.hpp"

// Exact numbers for the rare paths: constructed points, and what the predicates leave open. Heavy; include it in .cpp
// files only.
namespace toccata {

/// The value of a finite double.
[[nodiscard]] Rational to_rational(double value);

/// The double nearest to `value`, ties to even; ±∞ from 2^1024 − 2^970 on, 0 (never −0) up to 2^-1075.
[[nodiscard]] double nearest_double(const Rational& value);

/// The same for numerator · 2^exponent / denominator, in any terms; the denominator is positive.
[[nodiscard]] double nearest_double(const Integer& numerator, const Integer& denominator, int exponent);

[[nodiscard]] Sign sign_of(const Integer& value);
[[nodiscard]] Sign sign_of(const Rational& value);

struct RationalPoint2 {
  Rational x;
  Rational y;
  friend bool operator==(const RationalPoint2& p, const RationalPoint2& q) { return p.x == q.x && p.y == q.y; }
};

/// A point or vector with rational coordinates.
struct RationalPoint {
  Rational x;
  Rational y;
  Rational z;

  const Rational& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend bool operator==(const RationalPoint& p, const RationalPoint& q) {
    return p.x == q.x && p.y == q.y && p.z == q.z;
  }
};

[[nodiscard]] RationalPoint2 to_rational(const Vec2& point);
[[nodiscard]] RationalPoint to_rational(const Vec3& point);

/// Every coordinate rounded by `nearest_double`.
[[nodiscard]] Vec3 nearest_doubles(const RationalPoint& point);

[[nodiscard]] RationalPoint operator+(const RationalPoint& a, const RationalPoint& b);
[[nodiscard]] RationalPoint operator-(const RationalPoint& a, const RationalPoint& b);
[[nodiscard]] RationalPoint operator*(const Rational& s, const RationalPoint& a);
[[nodiscard]] Rational dot(const RationalPoint& a, const RationalPoint& b);
[[nodiscard]] RationalPoint cross(const RationalPoint& a, const RationalPoint& b);

/// The same as for Vec3: axis 0 → (y, z), 1 → (z, x), 2 → (x, y).
[[nodiscard]] RationalPoint2 drop_axis(const RationalPoint& p, int axis);

/// The signs of predicates.hpp, for rational points.
[[nodiscard]] Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c);
[[nodiscard]] Sign orient3d(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                            const RationalPoint& d);

}  // namespace toccata
