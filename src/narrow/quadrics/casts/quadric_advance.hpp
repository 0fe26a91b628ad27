#pragma once

#include "narrow/quadrics/distance/quadric_proof.hpp"

namespace toccata {

/// What planes in doubles prove of a quadric that moves at another, which stands.
struct QuadricAdvance {
  double free_until = 0;  ///< they are apart until this part of the way
  bool for_ever = false;  ///< and to its end
  Vec3 direction;         ///< of the last plane, of length 1, from the standing one; zero where there is none
  /// Where they came next to each other, as far as is seen; of no generators, where that is not known.
  BodyPoint on_a;
  BodyPoint on_b;
};

/// In the pair's frame, within the ranges of `PlainBody::height_at_most`. Ends when it is free until more than `limit`,
/// and where doubles gain nothing more. The steps up to there do not depend on the limit.
[[nodiscard]] QuadricAdvance advance_in_doubles(const PlainBody& a, const Vec3& motion, const PlainBody& b,
                                                double limit);

}  // namespace toccata
