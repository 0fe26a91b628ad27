#pragma once

#include <array>
#include <cmath>

#include "math/number_vector.hpp"
#include "math/vec3_measures.hpp"

namespace toccata {

/// a t² + 2 b t + c.
template <class Number>
struct Quadratic {
  Number a{};
  Number b{};
  Number c{};

  void add(const Number& p, const Number& v) {
    a = a + v * v;
    b = b + p * v;
    c = c + p * p;
  }
  [[nodiscard]] Number at(const Number& t) const { return c + t * ((b + b) + t * a); }
  [[nodiscard]] Number slope_at(const Number& t) const {
    const Number half = b + t * a;
    return half + half;
  }
  /// Less (p + t v)².
  void take(const Number& p, const Number& v) {
    a = a - v * v;
    b = b - p * v;
    c = c - p * p;
  }
};

/// A line where the shape is round: p + t v, and normals of planes across the axes. All are multiplied by the volume of
/// the axes, instead of by the inverse of their matrix, which saves the divisions.
template <class Number>
struct RoundLine {
  double begin = 0;  ///< the time that is 0 here
  VectorOf<Number> p{};
  VectorOf<Number> v{};
  Number volume{};  ///< what 1 is here
  std::array<Vec3, 3> normal{};

  /// The square of how far a point is from the axis.
  [[nodiscard]] Quadratic<Number> across() const {
    Quadratic<Number> q{v[0] * v[0], p[0] * v[0], p[0] * p[0]};
    q.add(p[1], v[1]);
    return q;
  }

  /// So that the volume is positive.
  void orient() {
    if (middle(volume) > 0) return;
    volume = -volume;
    for (std::size_t i = 0; i < 3; ++i) p[i] = -p[i], v[i] = -v[i], normal[i] = -normal[i];
  }
};

/// The part of a line that is in a shape.
template <class Number>
struct RayStretch {
  explicit RayStretch(double begin) : start(number_as<Number>(-begin)), end(start + number_as<Number>(1.0)) {}

  Number start;  ///< of the way
  Number end;
  Number enters = number_as<Number>(-HUGE_VAL);
  Number leaves = number_as<Number>(HUGE_VAL);
  enum class End { none, cap_below, cap_above, round } entered_by = End::none;
  bool empty = false;
  bool certain = true;

  /// The part of both; in doubt where the order of two ends is.
  void cut_front(const Number& time, End side) {
    if (std::isinf(middle(enters)) || (time - enters).is_positive()) {
      enters = time;
      entered_by = side;
    } else if (!(time - enters).is_negative()) {
      certain = false;
    }
  }
  void cut_back(const Number& time) {
    if (std::isinf(middle(leaves)) || (time - leaves).is_negative())
      leaves = time;
    else if (!(time - leaves).is_positive())
      certain = false;
  }

  /// Where z + t w ≥ 0.
  void cut_by_plane(const Number& z, const Number& w, End side) {
    if (w.is_positive()) return cut_front(-z / w, side);
    if (w.is_negative()) return cut_back(-z / w);
    // Nearly level: on one side all along the way, or not certain.
    const Number first = z + start * w, last = z + end * w;
    empty = empty || (first.is_negative() && last.is_negative());
    certain = certain && first.is_positive() == last.is_positive() && first.is_negative() == last.is_negative() &&
              (first.is_positive() || first.is_negative());
  }

  /// Where q ≤ 0, for one with a ≥ 0.
  void cut_by_roots(const Quadratic<Number>& q) {
    if (!q.a.is_positive()) return cut_by_level(q);
    const Number discriminant = q.b * q.b - q.a * q.c;
    if (discriminant.is_negative()) {
      empty = true;
    } else if (!discriminant.is_positive()) {
      certain = false;
    } else {
      const auto [less, greater] = roots(q, discriminant);
      cut_front(less, End::round);
      cut_back(greater);
    }
  }

  /// The same of a line along which q hardly changes.
  void cut_by_level(const Quadratic<Number>& q) {
    const Number at_start = q.at(start), at_end = q.at(end);
    // It is convex.
    if (at_start.is_negative() && at_end.is_negative()) return;
    // And nowhere below the line that touches it at the start.
    const Number ahead = at_start + (end - start) * q.slope_at(start);
    if (at_start.is_positive() && ahead.is_positive())
      empty = true;
    else
      certain = false;
  }

  /// Where q ≤ 0 and s + t w ≥ 0: of the two halves of a double cone the one towards which s grows.
  void cut_by_cone(const Quadratic<Number>& q, const Number& s, const Number& w) {
    const Number discriminant = q.b * q.b - q.a * q.c;
    if (q.a.is_positive()) {
      if (!discriminant.is_positive()) return cut_by_roots(q);
      // Between the roots it is on one side of the tip.
      const Number between = s * q.a - w * q.b;
      if (between.is_positive()) return cut_by_roots(q);
      empty = empty || between.is_negative();
      certain = certain && between.is_negative();
    } else if (q.a.is_negative() && discriminant.is_positive() && (w.is_positive() || w.is_negative())) {
      const auto [less, greater] = roots(q, discriminant);
      if (w.is_positive())
        cut_front(greater, End::round);
      else
        cut_back(less);
    } else {
      certain = false;
    }
  }

 private:
  struct Roots {
    Number less;
    Number greater;
  };
  static Roots roots(const Quadratic<Number>& q, const Number& discriminant) {
    const Number root = square_root(discriminant);
    // The sum of two of the same sign keeps its digits.
    const bool falling = middle(q.b) < 0;
    const Number sum = falling ? root - q.b : -(root + q.b);
    const Number one = q.c / sum, other = sum / q.a;
    return falling == q.a.is_positive() ? Roots{one, other} : Roots{other, one};
  }
};

}  // namespace toccata
