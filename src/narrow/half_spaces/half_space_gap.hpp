#pragma once

#include "narrow/half_spaces/half_space_heights.hpp"

namespace toccata {

/// How far a ball lies above a half-space: height / |normal| − radius, negative where it reaches in. With the points
/// in which that is attained: on the ball, and its foot on the plane.
class HalfSpaceGap {
 public:
  HalfSpaceGap(const Vec3& centre, double radius, const PosedHalfSpace& h);

  /// The sign of the gap less (x + y) / 2.
  [[nodiscard]] Sign compare(double x, double y) const;

  /// Rounded, a few last places off; where to start a search.
  [[nodiscard]] double approximate() const;

  // Every coordinate rounded to nearest.
  [[nodiscard]] Vec3 on_ball() const;
  [[nodiscard]] Vec3 foot() const;

 private:
  /// The sign of (coordinate of the ball's lowest point) − (x + y) / 2.
  [[nodiscard]] Sign compare_on_ball(int axis, double x, double y) const;

  Vec3 centre_;
  double radius_;
  PosedHalfSpace h_;
  ExactHeight exact_;
};

/// normal / |normal|: each coordinate is off by less than 2^-50 of itself.
[[nodiscard]] Vec3 unit_normal(const PosedHalfSpace& h);

}  // namespace toccata
