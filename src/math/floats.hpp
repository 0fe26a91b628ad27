#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "toccata/math/vec3.hpp"

// Doubles as floats.
namespace toccata {

inline constexpr float infinite_float = std::numeric_limits<float>::infinity();

/// Rounded to nearest.
inline std::array<float, 3> as_floats(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

inline Vec3 as_doubles(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

/// The float above the nearest one.
inline float up_to_float(double value) { return std::nextafter(static_cast<float>(value), infinite_float); }

}  // namespace toccata
