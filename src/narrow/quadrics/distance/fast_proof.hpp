#pragma once

#include <optional>

#include "narrow/quadrics/distance/fast_refinement.hpp"

namespace toccata {

/// What a guess of the nearest points proves, in world units.
struct FastDistance {
  double lower = 0;
  double upper = 0;
  Vec3 on_a;
  Vec3 on_b;
};

/// Sizes and lengths that are proved something of: squares and their products stay in the range of doubles.
[[nodiscard]] inline bool is_moderate(double x) { return x > 0x1p-290 && x < 0x1p290; }

/// The lower end is positive, and the interval no wider than 10⁻¹² of its upper end.
[[nodiscard]] inline bool is_narrow(const FastDistance& found) {
  return found.lower > 0 && found.upper - found.lower <= 1e-12 * found.upper;
}

[[nodiscard]] inline std::optional<FastDistance> if_narrow(const FastDistance& found) {
  if (is_narrow(found)) return found;
  return {};
}

/// With plain sums: twice the digits may make it narrow, as the rest of what it is wide by is no smaller.
[[nodiscard]] inline bool is_nearly_narrow(const FastDistance& found) {
  return found.lower > 0 && found.upper - found.lower <= 1e-11 * found.upper;
}

// The following are for pairs of moderate size, half axes and radii.

/// Where the interval is no wider than 10⁻¹² of its upper end.
[[nodiscard]] std::optional<FastDistance> proved_distance(const PosedQuadric& a, const PosedQuadric& b,
                                                          const FastRefinement& guess);
[[nodiscard]] std::optional<FastDistance> proved_distance(const PosedQuadric& a, const PosedPolytope& b,
                                                          const FastRefinement& guess);

/// Any two points, and any direction from about B to A: the exact distance is in the interval. The lower end is 0 where
/// nothing more is certain.
[[nodiscard]] FastDistance proved_interval(const PosedQuadric& a, const PosedQuadric& b, const FastSide& on_a,
                                           const FastSide& on_b, const Vec3& direction);
[[nodiscard]] FastDistance proved_interval(const PosedQuadric& a, const PosedPolytope& b, const FastSide& on_a,
                                           const FastSide& on_b, const Vec3& direction);

}  // namespace toccata
