#pragma once

#include <algorithm>

#include "toccata/shapes/primitives.hpp"

namespace toccata {

struct HeightsOfTriangle {
  double low;
  double high;
};

/// Rounded.
[[nodiscard]] inline HeightsOfTriangle heights_along(const Vec3& up, const Triangle& t) {
  const double x = dot(up, t[0]), y = dot(up, t[1]), z = dot(up, t[2]);
  return {std::min({x, y, z}), std::max({x, y, z})};
}

}  // namespace toccata
