#pragma once

#include <optional>

#include "narrow/smooth/distance/quick_proof.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata {

/// Whether numbers of a pair's frame, half axes and radii are so moderate that `QuickPair` may be asked.
[[nodiscard]] bool is_quick(const PosedSmooth& a, const PosedSmooth& b, const PairFrame& frame);
[[nodiscard]] bool is_quick(const PosedSmooth& a, const PosedConvex& b, const PairFrame& frame);

/// One question about a pair, in doubles: what it answers is proved, and what it does not answer is left to
/// `nearest_of`. The second shape is a PosedSmooth or a PosedConvex; the pair has to be quick.
template <class B>
class QuickPair {
 public:
  QuickPair(const PosedSmooth& a, const B& b, const PairFrame& frame, const Vec3& first_direction = {});

  /// Most pairs that are apart.
  std::optional<QuickDistance> distance();

  /// What `distance` did not prove, if it ended where the conditions of the nearest points hold.
  [[nodiscard]] const QuickPolish* guess() const { return is_guess_ ? &polish_ : nullptr; }

  /// Apart or contact, and both of most pairs.
  std::optional<SmoothContact> contact();
  bool is_apart();

  /// `factor` is that of the pair's frame.
  std::optional<bool> is_within(double tolerance, double factor);

 private:
  [[nodiscard]] bool is_meeting() const;
  void begin_polish();
  /// From the farthest points along the direction from B to A.
  double lower_along(const Vec3& direction);

  const PosedSmooth& a_;
  const B& b_;
  PlainBody body_a_;
  PlainBody body_b_;
  SmoothSearch search_;
  QuickPolish polish_;
  double gap_rounding_;  ///< what gaps along directions of the search may be off by
  bool is_guess_ = false;
};

}  // namespace toccata
