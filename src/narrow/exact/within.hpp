#pragma once

#include "toccata/narrow/convex_half_space.hpp"

// Is the exact distance of two shapes at most `tolerance`, which is not negative? Exact, for all finite coordinates.
namespace toccata {

[[nodiscard]] bool is_within(const PosedConvex& a, const PosedConvex& b, double tolerance,
                             ConvexWorkspace* workspace = nullptr);

/// The same, of shapes whose distance is known.
[[nodiscard]] bool is_within(const Distance& known, const PosedConvex& a, const PosedConvex& b, double tolerance);
[[nodiscard]] bool is_within(const Distance& known, const PosedConvex& a, const PosedHalfSpace& b, double tolerance);
[[nodiscard]] bool is_within(const Distance& known, const PosedHalfSpace& a, const PosedHalfSpace& b, double tolerance);

}  // namespace toccata
