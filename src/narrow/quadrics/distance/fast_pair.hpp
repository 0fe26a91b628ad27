#pragma once

#include <optional>

#include "narrow/quadrics/distance/fast_proof.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// Whether numbers of a pair's frame, half axes and radii are so moderate that `FastPair` may be asked.
[[nodiscard]] bool is_fast(const PosedQuadric& a, const PosedQuadric& b, const PairFrame& frame);
[[nodiscard]] bool is_fast(const PosedQuadric& a, const PosedPolytope& b, const PairFrame& frame);

/// One question about a pair, in doubles: what it answers is proved, and what it does not answer is left to
/// `nearest_of`. The second shape is a PosedQuadric or a PosedPolytope; the pair has to be quick.
template <class B>
class FastPair {
 public:
  FastPair(const PosedQuadric& a, const B& b, const PairFrame& frame, const Vec3& first_direction = {});

  /// Most pairs that are apart.
  std::optional<FastDistance> distance();

  /// Where `distance` has told nothing: of most pairs that meet, a point of both in the pair's frame.
  [[nodiscard]] std::optional<Vec3> common_point() const;

  /// What `distance` did not prove, if it ended where the conditions of the nearest points hold.
  [[nodiscard]] const FastRefinement* guess() const { return is_guess_ ? &refinement_ : nullptr; }

  /// Apart or contact, and both of most pairs.
  std::optional<QuadricContact> contact();
  bool is_apart();

  /// `factor` is that of the pair's frame.
  std::optional<bool> is_within(double tolerance, double factor);

 private:
  /// From the farthest points along the direction from B to A.
  double lower_along(const Vec3& direction);

  const PosedQuadric& a_;
  const B& b_;
  PlainBody body_a_;
  PlainBody body_b_;
  QuadricSearch search_;
  FastRefinement refinement_;
  double gap_rounding_;  ///< what gaps along directions of the search may be off by
  bool is_guess_ = false;
};

/// Apart or contact, and both of most pairs: by the way of those that have one of their own, else by `FastPair`.
[[nodiscard]] std::optional<QuadricContact> fast_contact(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] std::optional<QuadricContact> fast_contact(const PosedQuadric& a, const PosedPolytope& b);

// The same where the depth is asked for next. The search for a direction that parts ellipsoids takes long where they
// hardly meet, and that for their lowest place does not: so they are compared by their own way alone, and by the search
// after the depth where no lowest place was found.
[[nodiscard]] std::optional<QuadricContact> contact_before_depth(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] std::optional<QuadricContact> contact_before_depth(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] std::optional<QuadricContact> contact_after_depth(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] std::optional<QuadricContact> contact_after_depth(const PosedQuadric& a, const PosedPolytope& b);

}  // namespace toccata
