#pragma once

#include <optional>

#include "narrow/smooth/quick_polish.hpp"

namespace toccata {

/// What a guess of the nearest points proves, in world units.
struct QuickDistance {
  double lower = 0;
  double upper = 0;
  Vec3 on_a;
  Vec3 on_b;
};

// Of pairs of a size, half axes and radii from 2⁻³⁰⁰ to 2³⁰⁰, and of no more than eight vertices.
[[nodiscard]] std::optional<QuickDistance> proved_distance(const PosedSmooth& a, const PosedSmooth& b,
                                                           const QuickPolish& guess);
[[nodiscard]] std::optional<QuickDistance> proved_distance(const PosedSmooth& a, const PosedConvex& b,
                                                           const QuickPolish& guess);

}  // namespace toccata
