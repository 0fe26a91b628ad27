#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "math/double_word.hpp"
#include "narrow/quadrics/casts/ray_stretch.hpp"
#include "narrow/quadrics/exact_place.hpp"
#include "narrow/quadrics/kinds/kind_parts.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// u₁² + u₂² ≤ ((1 − u₃) / 2)² and |u₃| ≤ 1 along the half axes: the tip is up. What each member is for stands at the
/// concept QuadricKind.
struct ConeKind {
  using Shape = Cone;
  static constexpr Index generators = 2;
  static constexpr std::size_t columns = 2;
  static constexpr bool has_tip = true;
  static constexpr int caps = 1;
  static constexpr double last_sign = -1;
  static constexpr double level = 0;
  static constexpr double inner_height = -0.5;

  static QuadricReach reach(double across, double z) { return {std::max(across + z, -z), std::max(across - z, z)}; }
  static QuadricReach reach(double x, double y, double z) { return reach(std::hypot(x, y), z); }

  template <class Vector>
  static bool holds_within(const Vector& u) {
    const auto one = exactly(1.0), across = u[0] * u[0] + u[1] * u[1];
    if (!(one - u[2]).is_positive() || !(one + u[2]).is_positive()) return false;
    const auto reach = exactly(0.5) * (one - u[2]);
    return (reach * reach - across).is_positive();
  }

  template <class Number>
  static std::array<Number, 2> beyond_planes(const Number& at, const Number& reach) {
    return {(at + reach) - exactly(1), -at};
  }

  template <class Vector>
  static void turn_to_normal(Vector& y) {
    y[2] = -root_of(y[0] * y[0] + y[1] * y[1]);
  }

  static Sign side(const UnitPlace& place) {
    const auto& d = place.along;
    const WideInteger across = d[0] * d[0] + d[1] * d[1], below_tip = place.volume - d[2];
    return greatest_sign({WideInteger(4 * across) - below_tip * below_tip, -below_tip, -d[2] - place.volume});
  }

  static Sign sign_of_least_height(const WideInteger& middle, const WideInteger& x, const WideInteger& y,
                                   const WideInteger& z) {
    return std::min(sign_of(middle + z), sign_of_less_root(middle - z, x * x + y * y));
  }

  static void append_outward_normals(std::vector<IntegerVector>& found, const UnitPlace& place) {
    const auto& [d, volume, row] = place;
    if (d[2] == -volume) found.push_back(-row[2]);
    const WideInteger below_tip = volume - d[2];
    if (below_tip == 0) {
      // At the tip the planes along four lines of the side, and the one across the axis.
      found.push_back(row[2]);
      for (const IntegerVector& side : {row[0], row[1]}) {
        found.push_back(row[2] + WideInteger(2) * side);
        found.push_back(row[2] - WideInteger(2) * side);
      }
    } else if (4 * (d[0] * d[0] + d[1] * d[1]) == below_tip * below_tip) {
      found.push_back(WideInteger(4) * (d[0] * row[0] + d[1] * row[1]) + below_tip * row[2]);
    }
  }

  template <class Visit, class VisitAround>
  static void visit_places(const Vec3& middle, const std::array<Vec3, 3>& axis, const Visit& visit,
                           const VisitAround& visit_around) {
    visit_around(middle - axis[2]);
    for (const Vec3& along : {axis[0], axis[1]}) {
      visit(middle - 0.5 * along);
      visit(middle + 0.5 * along);
    }
  }

  template <class Number>
  static void cut(RayStretch<Number>& stretch, const RoundLine<Number>& line) {
    Quadratic<Number> q = line.across();
    stretch.cut_by_plane(line.p[2] + line.volume, line.v[2], RayStretch<Number>::End::cap_below);
    const Number half = number_as<Number>(0.5);
    const Number s = half * (line.volume - line.p[2]), w = half * -line.v[2];
    q.take(s, w);
    stretch.cut_by_cone(q, s, w);
  }

  template <class Number>
  static Vec3 round_normal(const RoundLine<Number>& line, const VectorOf<Number>& at) {
    const Number below_tip = line.volume - at[2];
    // Next to the tip, where the line comes from, rounding may turn the gradient round.
    if (!below_tip.is_positive()) return unit_or_zero({-middle(line.v[0]), -middle(line.v[1]), 0}) + Vec3{0, 0, 0.5};
    return {middle(at[0]), middle(at[1]), 0.25 * middle(below_tip)};
  }

  static double radius_at(const Vec3& half, double z) { return half.x * ((half.z - z) / (2 * half.z)); }
  static double width_at(double part) { return 1 - part; }
  static double beyond(const Vec3& half, double rim, double round, double n, double z) {
    return std::max(rim + n * (z + half.z), round - n * (half.z - z));
  }

  class Section {
   public:
    explicit Section(const Vec3& half) : radius_(half.x), half_height_(half.z) {
      const double side = 1 / std::sqrt(radius_ * radius_ + 4 * half_height_ * half_height_);
      slope_out_ = -radius_ * side;
      slope_up_ = 2 * half_height_ * side;
      side_length_ = 1 / side;
    }

    [[nodiscard]] AxialFoot foot(double out, double up) const {
      const double from_rim = out - radius_, from_base = up + half_height_;
      if (from_base <= 0) {
        if (from_rim <= 0)
          return {.out = out, .up = -half_height_, .share = 1, .slope_out = 1, .outside = from_base < 0};
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
    [[nodiscard]] double depth_of(double out, double up) const {
      const double from_base = up + half_height_;
      return std::min(from_base, (radius_ - out) * slope_up_ + from_base * slope_out_);
    }
    [[nodiscard]] AxialFoot farthest(double out, double up) const {
      if (half_height_ * up > radius_ * out - half_height_ * up) return {.up = half_height_};
      return {.out = radius_, .up = -half_height_};
    }

   private:
    double radius_;
    double half_height_;
    double slope_out_;  // from the rim to the tip
    double slope_up_;
    double side_length_;
  };
};

}  // namespace toccata
