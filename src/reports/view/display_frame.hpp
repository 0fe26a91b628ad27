#pragma once

#include <array>

#include "toccata/bounds/aabb.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata::io {

/// The coordinates in which pages draw: shown = (world − centre) / size, between about −1 and 1, so that tiny, huge
/// and far-away scenes fit the floats of a graphics card.
struct DisplayFrame {
  Vec3 centre{};
  double size = 1;

  /// Around a box; a single point gets the size 1. The box is finite or empty.
  static DisplayFrame around(const Aabb& box);

  [[nodiscard]] std::array<float, 3> shown(const Vec3& world) const;
};

}  // namespace toccata::io
