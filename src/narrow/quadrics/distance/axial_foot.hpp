#pragma once

#include <algorithm>
#include <cmath>

#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// The point of a cylinder or a cone nearest to a point outside, in the half plane from the axis through that point:
/// `out` from the axis, `up` along it from the middle. Its derivative by the point is, in the directions across the
/// half plane and within it, `share` and the projection onto the vector (slope_out, slope_up).
struct AxialFoot {
  double out = 0;
  double up = 0;
  double share = 0;
  double slope_out = 0;
  double slope_up = 0;
  bool outside = true;  ///< else nothing else is told
};

/// Of closed forms for the parts of its boundary: base and lid, rims, side, tip.
class AxialShape {
 public:
  /// `half`: the radius twice, and the half height; the tip of a cone is up.
  AxialShape(PosedQuadric::Kind kind, const Vec3& half)
      : radius_(half.x), half_height_(half.z), is_cone_(kind == PosedQuadric::Kind::cone) {
    if (!is_cone_) return;
    const double side = 1 / std::sqrt(radius_ * radius_ + 4 * half_height_ * half_height_);
    slope_out_ = -radius_ * side;
    slope_up_ = 2 * half_height_ * side;
    side_length_ = 1 / side;
  }

  [[nodiscard]] AxialFoot foot(double out, double up) const {
    return is_cone_ ? of_cone(out, up) : of_cylinder(out, up);
  }

  /// How far a point lies within, from the nearest part of the boundary; negative outside.
  [[nodiscard]] double depth_of(double out, double up) const {
    if (!is_cone_) return std::min(radius_ - out, half_height_ - std::fabs(up));
    const double from_base = up + half_height_;
    return std::min(from_base, (radius_ - out) * slope_up_ + from_base * slope_out_);
  }

  /// The farthest point along a direction with these parts, the first of them not negative.
  [[nodiscard]] AxialFoot farthest(double out, double up) const {
    if (is_cone_ && half_height_ * up > radius_ * out - half_height_ * up) return {.up = half_height_};
    return {.out = radius_, .up = is_cone_ ? -half_height_ : std::copysign(half_height_, up)};
  }

 private:
  [[nodiscard]] AxialFoot of_cylinder(double out, double up) const {
    const bool beside = out > radius_, beyond = std::fabs(up) > half_height_;
    AxialFoot foot;
    foot.out = beside ? radius_ : out;
    foot.up = beyond ? std::copysign(half_height_, up) : up;
    foot.share = beside ? radius_ / out : 1;
    foot.slope_out = beside ? 0 : 1;
    foot.slope_up = beyond ? 0 : 1;
    foot.outside = beside || beyond;
    return foot;
  }

  [[nodiscard]] AxialFoot of_cone(double out, double up) const {
    const double from_rim = out - radius_, from_base = up + half_height_;
    if (from_base <= 0) {
      if (from_rim <= 0) return {.out = out, .up = -half_height_, .share = 1, .slope_out = 1, .outside = from_base < 0};
      return {.out = radius_, .up = -half_height_, .share = radius_ / out};
    }
    if (!(from_rim * slope_up_ - from_base * slope_out_ > 0)) return {.outside = false};
    const double along = from_rim * slope_out_ + from_base * slope_up_;
    if (along <= 0) return {.out = radius_, .up = -half_height_, .share = radius_ / out};
    if (along >= side_length_) return {.up = half_height_};
    const double at = radius_ + along * slope_out_;
    return {.out = at,
            .up = std::fmin(along * slope_up_ - half_height_, half_height_),
            .share = at / out,
            .slope_out = slope_out_,
            .slope_up = slope_up_};
  }

  double radius_;
  double half_height_;
  double slope_out_ = 0;  // from the rim of a cone to its tip
  double slope_up_ = 0;
  double side_length_ = 0;
  bool is_cone_;
};

}  // namespace toccata
