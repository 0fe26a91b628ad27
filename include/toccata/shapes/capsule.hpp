#pragma once

#include "toccata/math/vec3.hpp"

namespace toccata {

/// A solid capsule: all points within `radius` of the segment between two points of the shape's own frame, which may be
/// equal. Its pose may not deform it (docs/truth.md).
class Capsule {
 public:
  /// Throws Error when the radius is not positive, or a number is not finite.
  Capsule(const Vec3& start, const Vec3& end, double radius);

  [[nodiscard]] const Vec3& start() const { return start_; }
  [[nodiscard]] const Vec3& end() const { return end_; }
  [[nodiscard]] double radius() const { return radius_; }

 private:
  Vec3 start_;
  Vec3 end_;
  double radius_;
};

}  // namespace toccata
