#pragma once

#include "toccata/math/vec3.hpp"

namespace toccata {

/// A solid ball: all points within `radius` of the centre, which is in the shape's own frame. Its pose may not deform
/// it (docs/truth.md).
class Sphere {
 public:
  /// Throws Error when the radius is not positive, or a number is not finite.
  explicit Sphere(double radius, const Vec3& centre = {});

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] const Vec3& centre() const { return centre_; }

 private:
  Vec3 centre_;
  double radius_;
};

}  // namespace toccata
