#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "narrow/quadrics/casts/ray_stretch.hpp"
#include "narrow/quadrics/exact_place.hpp"
#include "narrow/quadrics/kinds/kind_parts.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// |u| ≤ 1 along the half axes. What each member is for stands at the concept QuadricKind.
struct EllipsoidKind {
  using Shape = Ellipsoid;
  static constexpr Index generators = 1;
  static constexpr std::size_t columns = 3;
  static constexpr bool has_tip = false;
  static constexpr int caps = 0;
  static constexpr double last_sign = 1;
  static constexpr double level = 1;
  static constexpr double inner_height = 0;

  static QuadricReach reach(double x, double y, double z) {
    const double both = std::hypot(x, y, z);
    return {both, both};
  }

  template <class Vector>
  static bool holds_within(const Vector& u) {
    const auto across = u[0] * u[0] + u[1] * u[1];
    return (exactly(1.0) - (across + u[2] * u[2])).is_positive();
  }

  template <class Number>
  static std::array<Number, 0> beyond_planes(const Number&, const Number&) {
    return {};
  }

  template <class Vector>
  static void turn_to_normal(Vector&) {}

  static Sign side(const UnitPlace& place) {
    const auto& d = place.along;
    return greatest_sign({((d[0] * d[0] + d[1] * d[1]) + d[2] * d[2]) - place.volume * place.volume});
  }

  static Sign sign_of_least_height(const WideInteger& middle, const WideInteger& x, const WideInteger& y,
                                   const WideInteger& z) {
    return sign_of_less_root(middle, (x * x + y * y) + z * z);
  }

  static void append_outward_normals(std::vector<IntegerVector>& found, const UnitPlace& place) {
    const auto& [d, volume, row] = place;
    found.push_back((d[0] * row[0] + d[1] * row[1]) + d[2] * row[2]);
  }

  template <class Visit, class VisitAround>
  static void visit_places(const Vec3&, const std::array<Vec3, 3>&, const Visit&, const VisitAround&) {}

  template <class Number>
  static void cut(RayStretch<Number>& stretch, const RoundLine<Number>& line) {
    Quadratic<Number> q = line.across();
    q.add(line.p[2], line.v[2]);
    q.c = q.c - line.volume * line.volume;
    stretch.cut_by_roots(q);
  }

  template <class Number>
  static Vec3 round_normal(const RoundLine<Number>&, const VectorOf<Number>& at) {
    return {middle(at[0]), middle(at[1]), middle(at[2])};
  }
};

}  // namespace toccata
