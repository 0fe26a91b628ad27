#pragma once

#include "toccata/math/vec3.hpp"

namespace toccata {

/// One point, in the shape's own frame. A surface: it has no interior.
class Point {
 public:
  /// Throws Error when the position is not finite.
  explicit Point(const Vec3& position = {});

  [[nodiscard]] const Vec3& position() const { return position_; }

 private:
  Vec3 position_;
};

}  // namespace toccata
