#pragma once

#include "toccata/core/random.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// Its coordinates are drawn in order.
inline Vec3 vector_between(Random& random, double low, double high) {
  const double x = random.between(low, high), y = random.between(low, high), z = random.between(low, high);
  return {x, y, z};
}

}  // namespace toccata
