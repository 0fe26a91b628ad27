#include "narrow/quadrics/distance/fast_proof.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/expansion.hpp"
#include "math/vec3_measures.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"

// The difference z of a point of each shape is computed with twice the digits; then |z| is the upper end, and the lower
// end is z · d, less what the shapes reach beyond their points along d. That is nothing where a point is a vertex or
// lies at the end of an axis, and of second order where it lies on a round side, so that little is lost to rounding.
//
// Below u = 2⁻⁵³; an operation rounds by at most that part of its result. So a dot product of three terms is off by 3 u
// times that of the magnitudes, a length by 2.5 u of itself, a cross product by 2 √3 u of the product of the lengths.
// At each bound stands how many units its operations round; it counts at least an eighth more, which covers the terms
// of second order and the rounding of the bound.
//
// What is lost below the range of doubles is less than 2⁻⁴⁹⁰ in all, as all sizes are between 2⁻³⁰⁰ and 2³⁰⁰: squares
// of less than 2⁻¹⁰⁷⁴ count as 0. A distance of at least `least_distance` covers it: the ends of the interval have 2 u
// of it to spare.
namespace toccata {
namespace {

constexpr double least_distance = 0x1p-400;
/// Points of round sides are drawn in by this part, so that they are of the shape whatever was rounded: their length by
/// 2.5 u, the factor by 2 u, the point by u; towards a tip, how wide it is there by 3 u.
constexpr double round_drawn_in = 10 * unit_roundoff;

/// A sum with twice the digits (T. Ogita, S. M. Rump, S. Oishi, "Accurate sum and dot product", 2005).
class LongSum {
 public:
  void add(double x) {
    const TwoPart next = two_sum(sum_, x);
    sum_ = next.high;
    rest_ += next.low;
    size_ += std::fabs(x);
  }
  void add_product(double x, double y) {
    const TwoPart product = two_product(x, y);
    add(product.high);
    rest_ += product.low;
  }
  [[nodiscard]] double value() const { return sum_ + rest_; }
  /// The error of up to 24 terms: u of the value, and 24² u² of the magnitudes.
  [[nodiscard]] double error() const {
    return 2 * unit_roundoff * std::fabs(value()) + 2000 * unit_roundoff * unit_roundoff * size_;
  }

 private:
  double sum_ = 0;
  double rest_ = 0;
  double size_ = 0;
};

using LongVector = std::array<LongSum, 3>;

/// Rounded products of a vector with the columns of a matrix, and how far they may be off.
struct Products {
  Vec3 value;
  Vec3 error;
};

Products along_columns(const Mat3& m, const Vec3& d) {
  Products p;
  for (int j = 0; j < 3; ++j) {
    const Vec3 column = m.column(j);
    p.value[j] = dot(column, d);
    p.error[j] = 4 * unit_roundoff * dot(magnitudes(column), magnitudes(d));  // 3 u
  }
  return p;
}

/// No shorter.
double length_from_above(const Vec3& error) { return 1.01 * plain_length(error); }

/// At most what the image of the unit ball reaches beyond the image of p, |p| ≤ 1, along a direction whose product with
/// the map is m: |m| − m · p ≤ |m| (1 − |p|) + |m × p|² / (2 m · p). It holds in two and three dimensions. The
/// coordinates of p may be off by 2 u of themselves.
double beyond_round(const Vec3& m, const Vec3& error, const Vec3& p) {
  const double off = length_from_above(error), length = plain_length(m), part = plain_length(p);
  // 2.5 u of the length, 3 u of the product, 2 u of p, 2 u each of the difference and of the sum.
  const double plain = (length - dot(m, p)) + (2.1 * off + 13 * unit_roundoff * length);
  // 3 u of the product, 2 u of p, u of the difference.
  const double along = dot(m, p) - (1.1 * off + 8 * unit_roundoff * length);
  if (!(along > 0)) return plain;
  // 3.5 u of the product, 2 u of p, 2.5 u of its length, u of the sum.
  const double beside = plain_length(cross(m, p)) + (1.1 * off + 12 * unit_roundoff * length);
  // 2.5 u of the length, 3 u of the operations; 4.5 u of the part.
  const double fine = (length * (1 + 8 * unit_roundoff) + 1.1 * off) * std::max(0.0, (1 + 6 * unit_roundoff) - part) +
                      (0.5 + 0x1p-20) * beside * beside / along;
  return std::min(plain, fine);
}

/// A point of a quadric in its own frame.
class LocalPoint {
 public:
  LocalPoint(const PosedQuadric& shape, const FastSide& side) : shape_(shape), half_(shape.half()) {
    with_kind(shape.kind(), [&]<class Kind>(Kind kind) {
      if constexpr (AxialKind<Kind>)
        place_around_axis(kind, side);
      else
        place_in_ball(side);
    });
  }

  void add_to(LongVector& sum, double sign) const {
    for (int i = 0; i < 3; ++i) {
      LongSum& s = sum[static_cast<std::size_t>(i)];
      const Vec3& row = shape_.pose().linear[i];
      for (int j = 0; j < 3; ++j) s.add_product(sign * row[j], point_[j]);
      s.add(sign * shape_.pose().offset[i]);
    }
  }

  [[nodiscard]] Vec3 in_world() const { return transform(shape_.pose(), point_); }

  /// At most what the shape reaches beyond the point along the direction.
  [[nodiscard]] double beyond(const Vec3& direction) const {
    const Products n = along_columns(shape_.pose().linear, direction);
    const Vec3 m{half_.x * n.value.x, half_.y * n.value.y, half_.z * n.value.z};
    // A third more for what the products with the half axes round.
    const Vec3 error{1.5 * (half_.x * n.error.x), 1.5 * (half_.y * n.error.y), 1.5 * (half_.z * n.error.z)};
    return with_kind(shape_.kind(), [&]<class Kind>(Kind) {
      if constexpr (!AxialKind<Kind>) {
        return beyond_round(m, error, in_half_axes());
      } else {
        const Vec3 across{m.x, m.y, 0}, across_error{error.x, error.y, 0};
        const Vec3 p{point_.x / half_.x, point_.y / half_.x, 0};
        if (!Kind::has_tip) return beyond_round(across, across_error, p) + beyond_ends(n.value.z, n.error.z);
        return std::max(beyond_base(n, across, across_error, p), beyond_tip(n, across, across_error, p));
      }
    });
  }

 private:
  void place_in_ball(const FastSide& side) {
    const Vec3 v{side.round.x * half_.x, side.round.y * half_.y, side.round.z * half_.z};
    point_ = v;
    const double length = plain_length(in_half_axes());
    if (length > 1 - round_drawn_in) point_ = ((1 - round_drawn_in) / length) * v;
  }

  template <AxialKind Kind>
  void place_around_axis(Kind, const FastSide& side) {
    double upper = 0;
    for (std::size_t i = 0; i < side.size; ++i)
      if (side.generator[i] == 1) upper = side.size == 1 ? 1 : std::clamp(side.weight[i], 0.0, 1.0);
    const double z = upper == 0 ? -half_.z : upper == 1 ? half_.z : half_.z * (2 * upper - 1);
    const double reach = Kind::radius_at(half_, z);
    const Vec3 v{reach * side.round.x, reach * side.round.y, 0};
    const double length = plain_length(v), most = reach * (1 - round_drawn_in);
    point_ = length > most ? (most / length) * v : v;
    if (reach == 0) point_ = {};
    point_.z = z;
  }

  [[nodiscard]] Vec3 in_half_axes() const { return {point_.x / half_.x, point_.y / half_.y, point_.z / half_.z}; }

  /// 2 u of a product, u of the sum.
  [[nodiscard]] double beyond_ends(double nz, double error) const {
    const double up = half_.z - point_.z, down = half_.z + point_.z;
    return std::max(nz * up + 2 * (error * up) + 4 * unit_roundoff * std::fabs(nz * up),
                    -(nz * down) + 2 * (error * down) + 4 * unit_roundoff * std::fabs(nz * down));
  }

  // Each difference of the terms that nearly cancel rounds no more than the next term and what is left.

  /// 2.5 u of the length, 3 u of the product, u of p; 2 u of the rise, u of the difference; 3 u of what is left.
  [[nodiscard]] double beyond_base(const Products& n, const Vec3& across, const Vec3& error, const Vec3& p) const {
    const double up = half_.z + point_.z, rise = n.value.z * up;
    if (up == 0) return beyond_round(across, error, p);
    const double off = length_from_above(error), length = plain_length(across), left = (length - dot(across, p)) - rise;
    return left + (2.1 * off + 1.1 * (n.error.z * up) +
                   unit_roundoff * (8 * length + 4 * std::fabs(rise) + 4 * std::fabs(left)));
  }

  /// 3 u of the product, u of p; 2 u of the fall; 2 u of what is left.
  [[nodiscard]] double beyond_tip(const Products& n, const Vec3& across, const Vec3& error, const Vec3& p) const {
    const double down = half_.z - point_.z, fall = n.value.z * down;
    if (down == 0) return 0;
    const double off = length_from_above(error), length = plain_length(across), left = fall - dot(across, p);
    return left + (1.1 * off + 1.1 * (n.error.z * down) +
                   unit_roundoff * (6 * length + 4 * std::fabs(fall) + 4 * std::fabs(left)));
  }

  const PosedQuadric& shape_;
  Vec3 half_;
  Vec3 point_;
};

/// A point of a hull or a rounded shape: a vertex, steps from there to others, and a vector no longer than the radius.
class HullPoint {
 public:
  HullPoint(const PosedPolytope& shape, const FastSide& side)
      : shape_(shape), body_(side.body), first_(shape.vertex(side.generator[0])) {
    double total = 0;
    for (std::size_t i = 1; i < side.size; ++i) {
      weight_[i] = std::max(side.weight[i], 0.0);
      total += weight_[i];
    }
    const double less = total > 1 - 8 * unit_roundoff ? (1 - 8 * unit_roundoff) / total : 1;
    for (std::size_t i = 1; i < side.size; ++i) {
      weight_[i] *= less;
      other_[i] = shape.vertex(side.generator[i]);
      steps_ = steps_ + weight_[i] * (other_[i] - first_);
    }
    size_ = side.size;
    const double radius = shape.radius(), length = plain_length(side.round);
    if (radius > 0 && length > 0) round_ = (radius * (1 - round_drawn_in) / length) * side.round;
  }

  void add_to(LongVector& sum, double sign) const {
    for (int k = 0; k < 3; ++k) {
      LongSum& s = sum[static_cast<std::size_t>(k)];
      s.add(sign * first_[k]);
      s.add(sign * round_[k]);
      for (std::size_t i = 1; i < size_; ++i) {
        s.add_product(sign * weight_[i], other_[i][k]);
        s.add_product(-sign * weight_[i], first_[k]);
      }
    }
  }

  [[nodiscard]] Vec3 in_world() const { return (first_ + steps_) + round_; }

  [[nodiscard]] double beyond(const Vec3& direction) const {
    double most = 0;
    const Vec3 d = magnitudes(direction);
    // Each is rounded by 2 u, and once more when they are added.
    const double rounded_steps = size_ > 1 ? 4 * unit_roundoff * dot(d, sum_of_step_sizes()) : 0;
    const auto look_at = [&](Index i) {
      const Vec3 step = shape_.vertex(i) - first_, from = step - steps_;
      // u of each difference, 3 u of the product, u of the sum.
      const double off = 8 * unit_roundoff * (dot(d, magnitudes(step)) + dot(d, magnitudes(steps_)));
      if (size_ == 1 && step == Vec3{}) return;
      const double height = dot(direction, from) + (off + rounded_steps);
      if (!(height <= most)) most = height;  // NaN stays, and is no proof
    };
    if (shape_.in_world()) {
      for (Index i = 0; i < shape_.vertex_count(); ++i) look_at(i);
    } else {
      // One of those found is the highest.
      std::array<Index, most_highest> found;
      const Index count = body_->highest_generators(direction, found);
      if (count > most_highest) return HUGE_VAL;
      for (Index i = 0; i < count; ++i) look_at(found[i]);
    }
    const double radius = shape_.radius();
    if (!(radius > 0)) return most;
    return most + beyond_round(radius * direction, 2 * unit_roundoff * radius * d, (1 / radius) * round_);
  }

 private:
  [[nodiscard]] Vec3 sum_of_step_sizes() const {
    Vec3 sum;
    for (std::size_t i = 1; i < size_; ++i) sum = sum + weight_[i] * magnitudes(other_[i] - first_);
    return sum;
  }

  static constexpr Index most_highest = 16;

  const PosedPolytope& shape_;
  const PlainBody* body_;  ///< of a hull in its own frame
  Vec3 first_;
  std::array<Vec3, 3> other_{};
  std::array<double, 3> weight_{};
  std::size_t size_ = 0;
  Vec3 steps_;
  Vec3 round_;
};

template <class PointA, class PointB>
FastDistance interval_of(const PointA& x, const PointB& y, const Vec3& direction) {
  LongVector between;
  x.add_to(between, 1);
  y.add_to(between, -1);
  const Vec3 z{between[0].value(), between[1].value(), between[2].value()};
  const double off = between[0].error() + between[1].error() + between[2].error();
  const double distance = plain_length(z);
  FastDistance found;
  // 2.5 u of the length, 2 u of the operations.
  found.upper = (distance + off) * (1 + 8 * unit_roundoff);
  // 3 u of the product, 2 u of the differences.
  const double along = (dot(z, direction) - off) - 8 * unit_roundoff * distance;
  const double beyond = x.beyond(-direction) + y.beyond(direction);
  // 3 u of the sums of parts, u of the difference, 3.5 u of the quotient.
  const double lower = (along - beyond * (1 + 8 * unit_roundoff)) / plain_length(direction) * (1 - 8 * unit_roundoff);
  // Asked so that NaN is no proof.
  found.lower = lower > least_distance ? lower : 0;
  found.on_a = x.in_world();
  found.on_b = y.in_world();
  return found;
}

}  // namespace

FastDistance proved_interval(const PosedQuadric& a, const PosedQuadric& b, const FastSide& on_a, const FastSide& on_b,
                             const Vec3& direction) {
  return interval_of(LocalPoint(a, on_a), LocalPoint(b, on_b), direction);
}

FastDistance proved_interval(const PosedQuadric& a, const PosedPolytope& b, const FastSide& on_a, const FastSide& on_b,
                             const Vec3& direction) {
  return interval_of(LocalPoint(a, on_a), HullPoint(b, on_b), direction);
}

std::optional<FastDistance> proved_distance(const PosedQuadric& a, const PosedQuadric& b, const FastRefinement& guess) {
  return if_narrow(proved_interval(a, b, guess.on_a(), guess.on_b(), guess.direction()));
}

std::optional<FastDistance> proved_distance(const PosedQuadric& a, const PosedPolytope& b,
                                            const FastRefinement& guess) {
  return if_narrow(proved_interval(a, b, guess.on_a(), guess.on_b(), guess.direction()));
}

}  // namespace toccata
