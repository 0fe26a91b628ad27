#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "narrow/quadrics/distance/fast_refinement.hpp"
#include "narrow/quadrics/distance/quadric_proof.hpp"

namespace toccata {

/// Makes a near guess of the nearest points of two bodies (of the deepest ones, where they overlap a little) as good as
/// numbers are: by Newton's method on the conditions that hold there, with the generators that carry the points as
/// active set. With d the unit direction from B to A, γ the signed distance, x and y the points as BodyPoint makes
/// them:
///
///     x − y = γ d,  |d| = 1,  e Mᵀd = μ u with |u| = 1 (a round side, a rim)  or  Mᵀd = 0 (within a flat cap),
///
/// and all generators with a weight are equally high along d; e is −1 for A and 1 for B, M the columns, u the round
/// part. What it finds is still a guess, to be proved.
class NewtonRefinement {
 public:
  NewtonRefinement(const QuadricBody& a, const QuadricBody& b);

  /// Near a rim the corners do not tell whether the points lie on it or within the cap; the doubtful ones are taken the
  /// other way round the second time.
  enum class Attempt { first, second };

  void begin(std::span<const QuadricSearch::Corner> corners, const Vec3& direction, Attempt attempt);
  /// Where a refinement in doubles has ended.
  void begin(const FastRefinement& guess);
  /// A second attempt would begin otherwise.
  [[nodiscard]] bool doubtful() const { return doubtful_; }

  /// With doubles; tells whether the conditions hold for the active set that it ends with.
  bool settle();
  /// The same with residuals of 106 bits, from where `settle` has ended.
  void refine();

  [[nodiscard]] const FineDirection& direction() const { return direction_; }
  [[nodiscard]] double signed_distance() const { return distance_.high; }
  [[nodiscard]] BodyPoint on_a() const { return side_[0].point(); }
  [[nodiscard]] BodyPoint on_b() const { return side_[1].point(); }

 private:
  enum class Round { none, side, cap };

  struct Side : WeightedGenerators<DoubleWord, 4> {
    const QuadricBody* body = nullptr;
    double outward = 0;  ///< e
    std::array<DoubleWord, 3> round{};
    DoubleWord slope;  ///< μ
    Round kind = Round::none;
    std::size_t first_unknown = 0;

    [[nodiscard]] BodyPoint point() const;
    [[nodiscard]] std::size_t unknowns() const;
  };

  template <class Number>
  struct Values;
  template <class Number>
  [[nodiscard]] std::array<Number, 20> residuals() const;

  void begin_side(Side& side, std::span<const QuadricSearch::Corner> corners, Attempt attempt);
  void begin_side(Side& side, const FastSide& guess);
  void begin_distance();
  void number_unknowns();
  /// One step of Newton's; tells how large the residuals were.
  template <class Number>
  double step();
  void move_by(const std::array<double, 20>& change);
  bool converge();
  /// Mends what contradicts the conditions; tells whether anything did.
  bool change_active_set();
  bool change(Side& side);
  bool add_missing_generator(Side& side);
  bool add_finely_missing_generator(Side& side);
  void add_generator(Side& side, Index which);

  FineDirection direction_;
  DoubleWord distance_;
  std::array<Side, 2> side_;
  std::size_t unknowns_ = 0;
  bool doubtful_ = false;
  double slack_ = 0;  ///< what is rounding, of weights and of round parts
};

}  // namespace toccata
