#pragma once

#include <optional>

#include "narrow/smooth/distance/quick_polish.hpp"

namespace toccata {

/// What a guess of the nearest points proves, in world units.
struct QuickDistance {
  double lower = 0;
  double upper = 0;
  Vec3 on_a;
  Vec3 on_b;
};

/// Sizes and lengths that are proved something of: squares and their products stay in the range of doubles.
[[nodiscard]] inline bool is_moderate(double x) { return x > 0x1p-290 && x < 0x1p290; }

/// The lower end is positive, and the interval no wider than 10⁻¹² of its upper end.
[[nodiscard]] inline bool is_narrow(const QuickDistance& found) {
  return found.lower > 0 && found.upper - found.lower <= 1e-12 * found.upper;
}

[[nodiscard]] inline std::optional<QuickDistance> if_narrow(const QuickDistance& found) {
  if (is_narrow(found)) return found;
  return {};
}

/// With plain sums: twice the digits may make it narrow, as the rest of what it is wide by is no smaller.
[[nodiscard]] inline bool is_nearly_narrow(const QuickDistance& found) {
  return found.lower > 0 && found.upper - found.lower <= 1e-11 * found.upper;
}

// Of pairs of moderate size, half axes and radii.

/// Where the interval is no wider than 10⁻¹² of its upper end.
[[nodiscard]] std::optional<QuickDistance> proved_distance(const PosedSmooth& a, const PosedSmooth& b,
                                                           const QuickPolish& guess);
[[nodiscard]] std::optional<QuickDistance> proved_distance(const PosedSmooth& a, const PosedConvex& b,
                                                           const QuickPolish& guess);

/// Any two points, and any direction from about B to A: the exact distance is in the interval. The lower end is 0 where
/// nothing more is certain.
[[nodiscard]] QuickDistance proved_interval(const PosedSmooth& a, const PosedSmooth& b, const QuickSide& on_a,
                                            const QuickSide& on_b, const Vec3& direction);
[[nodiscard]] QuickDistance proved_interval(const PosedSmooth& a, const PosedConvex& b, const QuickSide& on_a,
                                            const QuickSide& on_b, const Vec3& direction);

}  // namespace toccata
