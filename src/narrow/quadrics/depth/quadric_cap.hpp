#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "narrow/quadrics/distance/quadric_proof.hpp"

namespace toccata {

/// Below this, heights in doubles have too few digits.
inline constexpr double shallow_height = 0x1p-8;

/// Which generators of A and of B a point of A − B is made of.
struct GeneratorPair {
  Index a = 0;
  Index b = 0;
  friend bool operator==(const GeneratorPair&, const GeneratorPair&) = default;
};

/// The highest point of A − B along a direction of length 1, but for rounding.
struct HighestPoint {
  Vec3 axis;
  QuadricSupport on_a;
  QuadricSupport on_b;
  Vec3 point;
  double height = 0;

  HighestPoint(const QuadricBody& a, const QuadricBody& b, const Vec3& direction)
      : axis(direction), on_a(a.support(direction)), on_b(b.support(-direction)), point(on_a.point - on_b.point) {
    height = dot(axis, point);
  }
  [[nodiscard]] GeneratorPair generators() const { return {on_a.generator, on_b.generator}; }
};

/// How high the hull of the pair's generators is along the axis, which is taken as it is.
template <class Number>
[[nodiscard]] Number height_of_pair(const QuadricBody& a, const QuadricBody& b, const GeneratorPair& pair,
                                    const Vec3& axis) {
  return generator_height<Number>(a, pair.a, fine(axis)) + generator_height<Number>(b, pair.b, fine(-axis));
}

/// A unit vector across one that is not zero.
[[nodiscard]] Vec3 some_across(const Vec3& d);

/// How high A − B is along the directions around one, told from that one alone. With x across the axis d, |d| = 1, the
/// generators of a pair make A − B along d + x at least
///
///     h + p · x + ½ xᵀG x   high for |x| ≤ t,
///
/// where p is their point that is highest along d, h its height, and G the curvature radii of the round parts of A and
/// B there, which are taken less the larger t is. For a round part |Mᵀ(d + x)| that follows from √(a² + b²) ≥ a + b² /
/// (2a + b² / 2a), with a and b the parts of Mᵀ(d + x) along Mᵀd and across it. Where there are several pairs, the
/// highest counts: two are the ends of an edge of A − B, three corners of a face, which may be round across. Where the
/// axis goes between their points and A − B is flatter than the ball of radius h, as where it is nearest to the origin,
/// no direction of the cap |x| ≤ t has a lower height than h.
class QuadricCap {
 public:
  /// The cap of the generators that are highest along the axis.
  QuadricCap(const QuadricBody& a, const QuadricBody& b, const HighestPoint& highest);
  /// The cap of up to three pairs, which need not be the highest ones: what is told is then still no more than the
  /// height.
  QuadricCap(const QuadricBody& a, const QuadricBody& b, const Vec3& axis, std::span<const GeneratorPair> generators);

  [[nodiscard]] const Vec3& axis() const { return axis_; }
  [[nodiscard]] std::span<const GeneratorPair> generators() const { return {generators_.data(), count_}; }
  /// The point of a pair, and what it is made of.
  [[nodiscard]] const QuadricSupport& on_a(std::size_t pair = 0) const { return on_a_[pair]; }
  [[nodiscard]] const QuadricSupport& on_b(std::size_t pair = 0) const { return on_b_[pair]; }
  [[nodiscard]] const Vec3& point(std::size_t pair = 0) const { return point_[pair]; }
  /// The points of A and of B whose difference is the point between the pairs' points through which the axis goes.
  [[nodiscard]] Vec3 between_on_a() const { return between(on_a_); }
  [[nodiscard]] Vec3 between_on_b() const { return between(on_b_); }
  /// The height of that point.
  [[nodiscard]] double height() const { return height_; }
  /// Makes the height as good as doubles are, where it is small as well.
  void refine();

  /// The axis of the lowest height near that the pairs have in common, by one step of Newton's; nothing where there is
  /// none.
  [[nodiscard]] std::optional<Vec3> lower_axis() const;

  /// The greatest of a few tangents t of the cap's angle for which its heights are, but for rounding of h, at least
  /// `least`; 0 where none is.
  [[nodiscard]] double widest_tangent(double least) const;
  /// Certainly no height along a direction of the cap is less, if that is `least` or less.
  [[nodiscard]] double proved_height(double tangent, double least);

 private:
  static constexpr std::size_t most_pairs = 3;

  /// A symmetric matrix in the plane across the axis: first, mixed, second.
  using Symmetric = std::array<double, 3>;

  /// The round part of a body, seen in that plane.
  struct Side {
    const QuadricBody* body = nullptr;
    bool is_round = false;
    bool is_flat = false;   ///< the direction of Mᵀd is rounding: the points are those that were taken, and no others
    double share = 1;       ///< of the weights, of pairs that have it
    double growth = 0;      ///< μ = |Mᵀd|
    double size = 0;        ///< |M|, or more
    double unsure = 0;      ///< of the direction of Mᵀd
    double lean = 0;        ///< |M m| in the plane, for the unit m along Mᵀd
    Symmetric curvature{};  ///< M (I − m mᵀ) Mᵀ in the plane
  };
  struct Curvature {
    Symmetric radii{};
    double unsure = 0;
  };

  [[nodiscard]] Vec3 between(const std::array<QuadricSupport, most_pairs>& on) const {
    return (weight_[0] * on[0].point + weight_[1] * on[1].point) + weight_[2] * on[2].point;
  }
  void look();
  void weigh();
  void look_at(Side& side, const Vec3& outward) const;
  template <class Number>
  [[nodiscard]] Number height_of_side(const Side& side, const QuadricSupport& on, const FineVector& outward) const;
  template <class Number>
  [[nodiscard]] Number weighed_height(const std::array<Number, most_pairs>& height) const;
  template <class Number>
  [[nodiscard]] double refined();
  /// At the axis itself; less h of the ball.
  [[nodiscard]] Symmetric plain_excess() const;
  /// No more than G for |x| ≤ t.
  [[nodiscard]] std::optional<Curvature> curvature_within(double tangent) const;
  /// How much lower than h it is at most within the cap; infinite where that is not known.
  [[nodiscard]] double loss_within(double tangent, double least) const;
  [[nodiscard]] double loss_between(double needed, double reach) const;
  [[nodiscard]] double loss_around_point(const Symmetric& excess, double tangent) const;
  [[nodiscard]] double loss_around_edge(const Symmetric& excess, double tangent) const;
  [[nodiscard]] double loss_around_face(const Symmetric& excess, double tangent) const;

  Vec3 axis_;
  std::array<GeneratorPair, most_pairs> generators_{};
  std::size_t count_ = 0;
  std::array<QuadricSupport, most_pairs> on_a_{};
  std::array<QuadricSupport, most_pairs> on_b_{};
  std::array<Vec3, most_pairs> point_{};
  std::array<double, most_pairs> weight_{1, 0, 0};  ///< of the points, for the one through which the axis goes
  double height_ = 0;
  double uneven_ = 0;                    ///< how much lower a point is than that one
  std::optional<double> refined_lower_;  ///< what the height is certainly no less than, where that was refined
  std::array<Vec3, 2> across_;           ///< of two pairs, the first leads from point to point
  std::array<Side, 2> side_;
  std::array<std::array<double, 2>, most_pairs> slope_{};  ///< the points in the plane
  double slope_unsure_ = 0;
};

}  // namespace toccata
