#pragma once

#include <algorithm>
#include <cmath>

#include "toccata/math/vec3.hpp"

// How large a vector is, in the ways that bounds need. Without a word about rounding, a measure is rounded to nearest.
namespace toccata {

inline Vec3 magnitudes(const Vec3& v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }

inline double largest_magnitude(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

inline double sum_of_magnitudes(const Vec3& v) { return (std::fabs(v.x) + std::fabs(v.y)) + std::fabs(v.z); }

/// Only for coordinates whose squares neither overflow nor underflow.
inline double plain_length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// The direction of v, zero of zero. Only for coordinates whose squares neither overflow nor underflow.
inline Vec3 plain_unit_or_zero(const Vec3& v) {
  const double length = plain_length(v);
  return length > 0 ? (1 / length) * v : Vec3{};
}

/// The direction of v, whatever its size; zero of zero, and of what is not finite.
inline Vec3 unit_or_zero(const Vec3& v) {
  const double largest = largest_magnitude(v);
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  const Vec3 scaled{v.x / largest, v.y / largest, v.z / largest};
  return (1 / plain_length(scaled)) * scaled;
}

/// v, with a length near 1, by a power of two: nothing is rounded but what underflows.
inline Vec3 near_unit(const Vec3& v) {
  const int exponent = -std::ilogb(largest_magnitude(v));
  return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

}  // namespace toccata
