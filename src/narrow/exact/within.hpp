#pragma once

#include "toccata/narrow/convex_half_space.hpp"

// Is the exact distance of two shapes at most `tolerance`, which is not negative? Exact, for all finite coordinates.
namespace toccata {

[[nodiscard]] bool is_within(const PosedConvex& a, const PosedConvex& b, double tolerance,
                             ConvexWorkspace* workspace = nullptr);

/// Proved in doubles to be farther apart than this: much quicker than a distance. False says nothing.
[[nodiscard]] bool certainly_beyond(const PosedConvex& a, const PosedConvex& b, double length,
                                    ConvexWorkspace* workspace = nullptr);

/// The same as is_within, of shapes whose distance is known.
[[nodiscard]] bool is_within(const Distance& known, const PosedConvex& a, const PosedConvex& b, double tolerance);
[[nodiscard]] bool is_within(const Distance& known, const PosedConvex& a, const PosedHalfSpace& b, double tolerance);
[[nodiscard]] bool is_within(const Distance& known, const PosedHalfSpace& a, const PosedHalfSpace& b, double tolerance);

}  // namespace toccata
