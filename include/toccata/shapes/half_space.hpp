#pragma once

#include "toccata/math/vec3.hpp"

namespace toccata {

/// All points p with (p − point) · normal ≤ 0, in the shape's own frame: solid, and without end on the side away from
/// the normal. Its pose may not deform it (docs/truth.md).
class HalfSpace {
 public:
  /// The normal points out of the solid and need not have length 1. Throws Error when it is zero, or a number is not
  /// finite.
  HalfSpace(const Vec3& point, const Vec3& normal);

  [[nodiscard]] const Vec3& point() const { return point_; }
  [[nodiscard]] const Vec3& normal() const { return normal_; }

 private:
  Vec3 point_;
  Vec3 normal_;
};

}  // namespace toccata
