#include "narrow/quadrics/casts/quadric_ray.hpp"

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// A line where the shape is round: p + t v, and normals of planes across the axes. All are multiplied by the volume of
/// the axes, instead of by the inverse of their matrix, which saves the divisions.
template <class Number>
struct RoundLine {
  double begin = 0;  ///< the time that is 0 here
  VectorOf<Number> p{};
  VectorOf<Number> v{};
  Number volume{};  ///< what 1 is here
  std::array<Vec3, 3> normal{};

  /// So that the volume is positive.
  void orient() {
    if (middle(volume) > 0) return;
    volume = -volume;
    for (std::size_t i = 0; i < 3; ++i) p[i] = -p[i], v[i] = -v[i], normal[i] = -normal[i];
  }
};

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

  /// Where q ≤ 0 and s + t w ≥ 0: of a cone along both ways from its tip, the one along which s grows.
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

template <class Number>
RayStretch<Number> stretch_within(PosedQuadric::Kind kind, const RoundLine<Number>& line) {
  using End = typename RayStretch<Number>::End;
  const VectorOf<Number>&p = line.p, &v = line.v;
  RayStretch<Number> stretch(line.begin);
  Quadratic<Number> q{v[0] * v[0], p[0] * v[0], p[0] * p[0]};
  q.add(p[1], v[1]);
  if (kind == PosedQuadric::Kind::ellipsoid) {
    q.add(p[2], v[2]);
  } else {
    stretch.cut_by_plane(p[2] + line.volume, v[2], End::cap_below);
  }
  if (kind == PosedQuadric::Kind::cone) {
    // x² + y² ≤ ((1 − z) / 2)².
    const Number half = number_as<Number>(0.5);
    const Number s = half * (line.volume - p[2]), w = half * -v[2];
    q.take(s, w);
    stretch.cut_by_cone(q, s, w);
    return stretch;
  }
  if (kind == PosedQuadric::Kind::cylinder) stretch.cut_by_plane(line.volume - p[2], -v[2], End::cap_above);
  q.c = q.c - line.volume * line.volume;
  stretch.cut_by_roots(q);
  return stretch;
}

/// Of a plane that touches a cone at its tip, which the line comes from.
template <class Number>
Vec3 normal_at_tip(const RoundLine<Number>& line) {
  return unit_or_zero({-middle(line.v[0]), -middle(line.v[1]), 0}) + Vec3{0, 0, 0.5};
}

/// Of the surface in the frame in which it is round, where the line enters it.
template <class Number>
Vec3 round_normal(PosedQuadric::Kind kind, const RoundLine<Number>& line, const RayStretch<Number>& stretch) {
  using End = typename RayStretch<Number>::End;
  if (stretch.entered_by == End::cap_below || stretch.entered_by == End::cap_above)
    return {0, 0, stretch.entered_by == End::cap_above ? 1.0 : -1.0};
  VectorOf<Number> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = line.p[i] + stretch.enters * line.v[i];
  const Vec3 normal{middle(at[0]), middle(at[1]), middle(at[2])};
  if (kind == PosedQuadric::Kind::ellipsoid) return normal;
  if (kind == PosedQuadric::Kind::cylinder) return {normal.x, normal.y, 0};
  const Number below_tip = line.volume - at[2];
  // Next to the tip rounding may turn the gradient round.
  if (!below_tip.is_positive()) return normal_at_tip(line);
  // Of x² + y² = ((1 − z) / 2)² the gradient.
  return {normal.x, normal.y, 0.25 * middle(below_tip)};
}

template <class Number>
std::optional<LineWithin<Number>> within(PosedQuadric::Kind kind, RoundLine<Number> line) {
  line.orient();
  if (!line.volume.is_positive()) return {};
  const RayStretch<Number> stretch = stretch_within(kind, line);
  LineWithin<Number> found;
  found.empty = stretch.empty;
  if (found.empty) return found;
  if (!stretch.certain) return {};
  const Number length = stretch.leaves - stretch.enters;
  const bool unbounded = std::isinf(middle(stretch.enters)) || std::isinf(middle(stretch.leaves));
  if (!unbounded && !length.is_positive() && !length.is_negative()) return {};
  found.empty = !unbounded && length.is_negative();
  const Number begin = number_as<Number>(line.begin);
  found.enters = begin + stretch.enters;
  found.leaves = begin + stretch.leaves;
  if (found.empty || std::isinf(middle(stretch.enters))) return found;
  // A normal is mapped by the inverse of the transpose.
  const Vec3 out = round_normal(kind, line, stretch);
  found.normal = (out.x * line.normal[0] + out.y * line.normal[1]) + out.z * line.normal[2];
  return found;
}

/// What is lost below the range is little beside what is rounded.
bool are_moderate_axes(const std::array<Vec3, 3>& axis, double size_from, double size_along) {
  constexpr double least = 0x1p-200, most = 0x1p200;
  for (const Vec3& a : axis)
    if (!(sum_of_magnitudes(a) > least && sum_of_magnitudes(a) < most)) return false;
  return size_from < most && size_along < most;
}

}  // namespace

template <class Number>
std::optional<LineWithin<Number>> line_within(const RoundAndLine<Number>& given) {
  RoundLine<Number> line;
  for (std::size_t i = 0; i < 3; ++i) {
    const VectorOf<Number> normal = outer(given.axis[(i + 1) % 3], given.axis[(i + 2) % 3]);
    line.p[i] = inner(normal, given.from);
    line.v[i] = inner(normal, given.along);
    line.normal[i] = {middle(normal[0]), middle(normal[1]), middle(normal[2])};
    if (i == 0) line.volume = inner(normal, given.axis[0]);
  }
  return within(given.kind, line);
}

template std::optional<LineWithin<BoundedNumber>> line_within(const RoundAndLine<BoundedNumber>&);

/// From near the middle of the shape on, so that little cancels. A component of a cross product is off by less than 5
/// roundings of the product of the sums of magnitudes, a product with it by less than 10, those of the axes included;
/// the place from which on by less than 4 of what it is the sum of.
std::optional<LineWithin<BoundedDouble>> fast_line_within(PosedQuadric::Kind kind, const std::array<Vec3, 3>& axis,
                                                          const Vec3& from, const Vec3& along) {
  constexpr double rounding = 0x1p-53;
  RoundLine<BoundedDouble> line;
  line.begin = -dot(from, along) / dot(along, along);
  const Vec3 near = from + line.begin * along;
  const double size_along = sum_of_magnitudes(along), size_near = sum_of_magnitudes(near);
  const double summed = sum_of_magnitudes(from) + std::fabs(line.begin) * size_along;
  if (!are_moderate_axes(axis, summed, size_along)) return {};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &u = axis[(i + 1) % 3], &w = axis[(i + 2) % 3];
    const double part = 10 * rounding * sum_of_magnitudes(u) * sum_of_magnitudes(w);
    const Vec3 normal = cross(u, w);
    line.p[i] = {dot(normal, near), part * (size_near + 0.4 * summed) + BoundedNumber::underflow};
    line.v[i] = {dot(normal, along), part * size_along + BoundedNumber::underflow};
    line.normal[i] = normal;
    if (i == 0) line.volume = {dot(normal, axis[0]), part * sum_of_magnitudes(axis[0]) + BoundedNumber::underflow};
  }
  return within(kind, line);
}

}  // namespace toccata
