#pragma once

namespace toccata {

/// A solid cone around the z axis of its own frame: its base, a disc of the radius, at z = −half_height, its tip at
/// z = half_height. Any pose that is not singular may place it, one that deforms included (docs/truth.md, "quadric").
class Cone {
 public:
  /// Throws Error when a number is not positive, or not finite.
  Cone(double radius, double half_height);

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] double half_height() const { return half_height_; }

 private:
  double radius_;
  double half_height_;
};

}  // namespace toccata
