#pragma once

namespace toccata {

/// A solid cylinder around the z axis of its own frame, from z = −half_height to z = half_height. Any pose that is not
/// singular may place it, one that deforms included (docs/truth.md, "quadric").
class Cylinder {
 public:
  /// Throws Error when a number is not positive, or not finite.
  Cylinder(double radius, double half_height);

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double half_height() const { return half_height_; }

 private:
  double radius_;
  double half_height_;
};

}  // namespace toccata
