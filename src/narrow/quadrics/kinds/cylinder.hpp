#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "narrow/quadrics/casts/ray_stretch.hpp"
#include "narrow/quadrics/exact_place.hpp"
#include "narrow/quadrics/kinds/kind_parts.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// u₁² + u₂² ≤ 1 and |u₃| ≤ 1 along the half axes. What each member is for stands at the concept QuadricKind.
struct CylinderKind {
  using Shape = Cylinder;
  static constexpr Index generators = 2;
  static constexpr std::size_t columns = 2;
  static constexpr bool has_tip = false;
  static constexpr int caps = 2;
  static constexpr double last_sign = 0;
  static constexpr double level = 1;
  static constexpr double inner_height = 0;

  static QuadricReach reach(double across, double z) {
    const double both = across + std::abs(z);
    return {both, both};
  }
  static QuadricReach reach(double x, double y, double z) { return reach(std::hypot(x, y), z); }

  template <class Vector>
  static bool holds_within(const Vector& u) {
    const auto one = exactly(1.0), across = u[0] * u[0] + u[1] * u[1];
    return (one - u[2]).is_positive() && (one + u[2]).is_positive() && (one * one - across).is_positive();
  }

  template <class Number>
  static std::array<Number, 2> beyond_planes(const Number& at, const Number& reach) {
    return {(at + reach) - exactly(1), (reach - at) - exactly(1)};
  }

  template <class Vector>
  static void turn_to_normal(Vector& y) {
    y[2] = {0, 0};
  }

  static Sign side(const UnitPlace& place) {
    const auto& d = place.along;
    const WideInteger &volume = place.volume, across = d[0] * d[0] + d[1] * d[1];
    return greatest_sign({across - volume * volume, d[2] - volume, -d[2] - volume});
  }

  static Sign sign_of_least_height(const WideInteger& middle, const WideInteger& x, const WideInteger& y,
                                   const WideInteger& z) {
    return sign_of_less_root(middle - abs(z), x * x + y * y);
  }

  static void append_outward_normals(std::vector<IntegerVector>& found, const UnitPlace& place) {
    const auto& [d, volume, row] = place;
    if (d[2] == -volume) found.push_back(-row[2]);
    if (d[0] * d[0] + d[1] * d[1] == volume * volume) found.push_back(d[0] * row[0] + d[1] * row[1]);
    if (d[2] == volume) found.push_back(row[2]);
  }

  template <class Visit, class VisitAround>
  static void visit_places(const Vec3& middle, const std::array<Vec3, 3>& axis, const Visit&,
                           const VisitAround& visit_around) {
    visit_around(middle - axis[2]);
    visit_around(middle + axis[2]);
  }

  template <class Number>
  static void cut(RayStretch<Number>& stretch, const RoundLine<Number>& line) {
    using End = typename RayStretch<Number>::End;
    Quadratic<Number> q = line.across();
    stretch.cut_by_plane(line.p[2] + line.volume, line.v[2], End::cap_below);
    stretch.cut_by_plane(line.volume - line.p[2], -line.v[2], End::cap_above);
    q.c = q.c - line.volume * line.volume;
    stretch.cut_by_roots(q);
  }

  template <class Number>
  static Vec3 round_normal(const RoundLine<Number>&, const VectorOf<Number>& at) {
    return {middle(at[0]), middle(at[1]), 0};
  }

  static double radius_at(const Vec3& half, double) { return half.x; }
  static double width_at(double) { return 1; }

  static double beyond(const Vec3& half, double rim, double, double n, double z) {
    return rim + (half.z * std::fabs(n) + n * z);
  }

  class Section {
   public:
    explicit Section(const Vec3& half) : radius_(half.x), half_height_(half.z) {}

    [[nodiscard]] AxialFoot foot(double out, double up) const {
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
    [[nodiscard]] double depth_of(double out, double up) const {
      return std::min(radius_ - out, half_height_ - std::fabs(up));
    }
    [[nodiscard]] AxialFoot farthest(double, double up) const {
      return {.out = radius_, .up = std::copysign(half_height_, up)};
    }

   private:
    double radius_;
    double half_height_;
  };
};

}  // namespace toccata
