#pragma once

#include "narrow/smooth/distance/smooth_polish.hpp"
#include "toccata/narrow/smooth.hpp"

namespace toccata {

/// What is proved of two bodies, in the pair's frame.
struct SmoothNearest {
  double lower = 0;         ///< no less far apart
  double upper = HUGE_VAL;  ///< no farther, as the two points show
  Vec3 on_a;
  Vec3 on_b;
  /// From B to A, as `SmoothPolish` has it: across it they are `lower` apart, or what was the best there is.
  FineDirection direction;
  SmoothContact contact = SmoothContact::undecided;
  /// Then, where that was the proof: four points of A − B around the origin.
  std::array<SmoothSearch::Corner, 4> around{};
  bool is_around = false;
  bool narrow = false;  ///< the interval is as narrow as is promised
};

/// How much is asked: whether they meet, or how far apart they are.
enum class SmoothQuestion : std::uint8_t { meeting, distance };

/// A is made of a smooth shape. Where a guess of the nearest points is given, it is looked at first.
[[nodiscard]] SmoothNearest nearest_of(const SmoothBody& a, const SmoothBody& b, SmoothQuestion question,
                                       const QuickPolish* guess = nullptr);

// The same of shapes in their pair's frame. Where this leaves open whether they meet, exact signs tell whether one
// contains the middle of the other: of shapes that are tiny beside it, all simplices may be flat for doubles.
[[nodiscard]] SmoothNearest nearest_of(const PosedSmooth& a, const SmoothBody& body_a, const PosedSmooth& b,
                                       const SmoothBody& body_b, SmoothQuestion question,
                                       const QuickPolish* guess = nullptr);
[[nodiscard]] SmoothNearest nearest_of(const PosedSmooth& a, const SmoothBody& body_a, const PosedConvex& b,
                                       const SmoothBody& body_b, SmoothQuestion question,
                                       const QuickPolish* guess = nullptr);

}  // namespace toccata
