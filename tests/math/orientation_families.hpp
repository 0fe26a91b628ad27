#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/math/vec3.hpp"

// Families of four points, most of them in one plane or a hair beside it, for every stage of the orientation
// predicates.
namespace toccata::test {

using FourPoints = std::array<Vec3, 4>;

inline double random_finite(Random& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random.bits());
    if (std::isfinite(value)) return value;
  }
}

inline double integer_between(Random& random, int low, int high) {
  return low + static_cast<double>(random.below(static_cast<std::uint64_t>(high - low) + 1));
}

inline double power_of_two_between(Random& random, int low, int high) {
  return std::ldexp(1.0, static_cast<int>(integer_between(random, low, high)));
}

/// Four points, each coordinate drawn anew from `draw`.
template <typename Draw>
FourPoints independent(Draw draw) {
  FourPoints points;
  for (Vec3& p : points) p = {draw(), draw(), draw()};
  return points;
}

inline FourPoints uniform(Random& random) {
  return independent([&] { return random.between(-1, 1); });
}

inline FourPoints on_small_grid(Random& random) {
  return independent([&] { return integer_between(random, -3, 3); });
}

/// Exactly coplanar, sometimes collinear, with integer coordinates below 2^24.
inline FourPoints coplanar(Random& random) {
  const auto vector = [&](int size) {
    return Vec3{integer_between(random, -size, size), integer_between(random, -size, size),
                integer_between(random, -size, size)};
  };
  const Vec3 a = vector(1 << 20), u = vector(1 << 20);
  const Vec3 v = random.below(4) == 0 ? integer_between(random, -2, 2) * u : vector(1 << 20);
  const double i = integer_between(random, -4, 4), j = integer_between(random, -4, 4);
  FourPoints points{a, a + u, a + v, a + i * u + j * v};
  std::swap(points[random.below(4)], points[3]);
  return points;
}

inline FourPoints scaled_by(double factor, FourPoints points) {
  for (Vec3& p : points) p = factor * p;
  return points;
}

/// Each axis by a factor of its own.
inline FourPoints stretched_by(const Vec3& factors, FourPoints points) {
  for (Vec3& p : points) p = {factors.x * p.x, factors.y * p.y, factors.z * p.z};
  return points;
}

/// One coordinate moved to a neighbouring double.
inline FourPoints nudged(Random& random, FourPoints points) {
  Vec3& point = points[random.below(4)];
  double& coordinate = point[static_cast<int>(random.below(3))];
  coordinate = std::nextafter(coordinate, random.below(2) == 0 ? -HUGE_VAL : HUGE_VAL);
  return points;
}

/// Coplanar but for the rounding of the last point.
inline FourPoints rounded_into_plane(Random& random) {
  FourPoints p = uniform(random);
  const double s = random.between(-1, 2), t = random.below(4) == 0 ? 0 : random.between(-1, 2);
  p[3] = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
  return p;
}

inline FourPoints moved_far(Random& random) {
  FourPoints points = random.below(2) == 0 ? on_small_grid(random) : uniform(random);
  const Vec3 offset{random.between(-1e15, 1e15), random.between(-1e15, 1e15), random.between(-1e15, 1e15)};
  for (Vec3& p : points) p = p + offset;
  return points;
}

/// Coplanar, times a power of two with an exponent in [low, high].
inline FourPoints scaled_coplanar(Random& random, int low, int high) {
  const double factor = power_of_two_between(random, low, high);
  return scaled_by(factor, coplanar(random));
}

inline FourPoints tiny(Random& random) {
  switch (random.below(4)) {
    case 0:
      return scaled_by(5e-324, on_small_grid(random));
    case 1:
      return scaled_coplanar(random, -1074, -900);
    case 2:
      return nudged(random, scaled_by(1e-300, coplanar(random)));
    default:
      return scaled_by(1e-310, uniform(random));
  }
}

/// Up to the largest double, so that differences overflow.
inline FourPoints huge(Random& random) {
  switch (random.below(4)) {
    case 0:
      return scaled_by(0x1p1022, on_small_grid(random));
    case 1:
      return scaled_coplanar(random, 900, 999);
    case 2:
      return nudged(random, scaled_by(1e300, coplanar(random)));
    default:
      return scaled_by(0x1.fffffffffffffp1023, uniform(random));
  }
}

/// Every exponent a double can have.
inline FourPoints any_doubles(Random& random) {
  return independent([&] { return random_finite(random); });
}

inline FourPoints mixed_magnitudes(Random& random) {
  return independent([&] {
    const double size = power_of_two_between(random, -60, 60);
    return size * random.between(-1, 1);
  });
}

inline FourPoints repeated(Random& random) {
  FourPoints points = random.below(2) == 0 ? mixed_magnitudes(random) : any_doubles(random);
  const std::size_t from = random.below(4);
  points[(from + 1 + random.below(3)) % 4] = points[from];
  return points;
}

/// Where the expansions stop and the integers begin, and where products of three begin to under- and overflow.
inline FourPoints near_range_limits(Random& random) {
  constexpr std::array<int, 6> exponents{-1000, -360, -320, 280, 320, 340};
  const double limit = std::ldexp(1.0, exponents[random.below(6)]);
  const double factor = limit * power_of_two_between(random, -4, 4);
  return scaled_by(factor, random.below(2) == 0 ? coplanar(random) : rounded_into_plane(random));
}

/// Axes of very different size: single products leave the range of doubles although the whole does not.
inline FourPoints stretched(Random& random) {
  const auto factor = [&] { return power_of_two_between(random, -700, 700); };
  const FourPoints points = random.below(2) == 0 ? coplanar(random) : nudged(random, coplanar(random));
  return stretched_by({factor(), factor(), factor()}, points);
}

using ThreePoints = std::array<Vec2, 3>;

/// Three of the points without one axis; in half the cases the third is put on the line of the others, up to rounding.
inline ThreePoints flattened(Random& random, const FourPoints& points) {
  const int axis = static_cast<int>(random.below(3));
  const Vec2 a = drop_axis(points[0], axis), b = drop_axis(points[1], axis), c = drop_axis(points[2], axis);
  const double s = random.below(2) == 0 ? integer_between(random, -3, 3) : random.between(-1, 2);
  const Vec2 on_line{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
  const bool replace = random.below(2) == 0 && std::isfinite(on_line.x) && std::isfinite(on_line.y);
  return {a, b, replace ? on_line : c};
}

struct OrientationFamily {
  std::string name;
  FourPoints (*draw)(Random&);
};

inline const std::vector<OrientationFamily>& orientation_families() {
  static const std::vector<OrientationFamily> families{
      {"uniform", uniform},
      {"grid", on_small_grid},
      {"coplanar", coplanar},
      {"one-ulp", [](Random& random) { return nudged(random, coplanar(random)); }},
      {"rounded-into-plane", rounded_into_plane},
      {"far", moved_far},
      {"tiny", tiny},
      {"huge", huge},
      {"any-doubles", any_doubles},
      {"mixed-magnitudes", mixed_magnitudes},
      {"repeated", repeated},
      {"range-limits", near_range_limits},
      {"stretched", stretched}};
  return families;
}

}  // namespace toccata::test
