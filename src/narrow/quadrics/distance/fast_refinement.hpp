#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "narrow/quadrics/distance/quadric_search.hpp"

namespace toccata {

/// What carries the nearest point of one body: Σ λ_i centre_i + (Σ λ_i grown_i) · M u.
struct FastSide : WeightedGenerators<double, 3> {
  const PlainBody* body = nullptr;
  double outward = 0;   ///< 1, where d points away from the body, and −1
  Vec3 round;           ///< u
  bool in_cap = false;  ///< u lies within a disc, else on the ball

  [[nodiscard]] double grown_weight() const;
};

/// The nearest points of two bodies by Newton's method on the unit direction d from B to A alone, where at most two
/// edge directions are active: the directions between generators of equal height, and the two of a cap. Then the
/// equations
///
///     (Tᵀ H T + γ) a − Tᵀ E λ' = Tᵀ z,  Eᵀ T a = −Eᵀ d,
///
/// with z = x − y, γ = z · d, T across d, and H the second derivative of the heights, have a closed form. What it finds
/// is a guess, to be proved; what it does not find is left to `NewtonRefinement`.
class FastRefinement {
 public:
  FastRefinement(const PlainBody& a, const PlainBody& b);

  /// Takes the nearest points of a search as they are.
  void begin(std::span<const QuadricSearch::Corner> corners, const Vec3& direction);
  /// Goes on from there; tells whether the conditions hold where it ends.
  bool run();
  /// One step more, from where `run` has ended; tells whether the conditions hold.
  bool refine();

  [[nodiscard]] const Vec3& direction() const { return direction_; }
  [[nodiscard]] const FastSide& on_a() const { return side_[0]; }
  [[nodiscard]] const FastSide& on_b() const { return side_[1]; }

 private:
  enum class Step { far, small, failed };

  struct Edge {
    Vec3 along;  ///< how z changes
    FastSide* side = nullptr;
    std::size_t which = 0;  ///< of its weights, or of its round part
  };

  /// The point that carries a side, and how the direction changes it: by `bend` times M (1 − u uᵀ) Mᵀ.
  struct Witness {
    Vec3 point;
    double bend = 0;  ///< grown weight / |Mᵀd|
  };

  void begin_side(FastSide& side, std::span<const QuadricSearch::Corner> corners);
  [[nodiscard]] Witness witness_of(FastSide& side) const;
  /// False where there are more than two.
  bool collect_edges();
  void collect_edges(FastSide& side);
  Step step();
  void turn_by(const Vec3& turn, double squared);
  void move_by(const std::array<double, 2>& along_edges);
  bool change(FastSide& side);
  void settle_round_parts();

  Vec3 direction_;
  std::array<FastSide, 2> side_;
  std::array<Edge, 2> edge_{};
  std::size_t edges_ = 0;
};

}  // namespace toccata
