#pragma once

#include "toccata/narrow/convex_convex.hpp"

// Is the exact distance of two shapes at most `tolerance`, which is not negative? Exact, for all finite coordinates.
namespace toccata {

[[nodiscard]] bool is_within(const PosedPolytope& a, const PosedPolytope& b, double tolerance,
                             SimplexCache* workspace = nullptr);

/// Proved in doubles to be farther apart than this: much quicker than a distance. False says nothing.
[[nodiscard]] bool certainly_beyond(const PosedPolytope& a, const PosedPolytope& b, double length,
                                    SimplexCache* workspace = nullptr);

/// The same as is_within, of shapes whose distance is known.
[[nodiscard]] bool is_within(const Distance& known, const PosedPolytope& a, const PosedPolytope& b, double tolerance);
[[nodiscard]] bool is_within(const Distance& known, const PosedPolytope& a, const PosedHalfSpace& b, double tolerance);
[[nodiscard]] bool is_within(const Distance& known, const PosedHalfSpace& a, const PosedHalfSpace& b, double tolerance);

}  // namespace toccata
