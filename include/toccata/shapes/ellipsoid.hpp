#pragma once

#include "toccata/math/vec3.hpp"

namespace toccata {

/// A solid ellipsoid around the origin of its own frame, its half axes along the axes. Any pose that is not singular
/// may place it, one that deforms included (docs/truth.md, "quadric").
class Ellipsoid {
 public:
  /// Throws Error when a half axis is not positive, or not finite.
  explicit Ellipsoid(const Vec3& half_axes);

  [[nodiscard]] const Vec3& half_axes() const { return half_axes_; }

 private:
  Vec3 half_axes_;
};

}  // namespace toccata
