#pragma once

#include <optional>

#include "narrow/smooth/distance/smooth_nearest.hpp"
#include "narrow/smooth/pair_frame.hpp"

namespace toccata {

// Where the search left open whether two shapes meet: a world point that exact signs find in both, of those next to the
// nearest points that were found. Shapes that touch where numbers of few digits put them, such as aligned ones at whole
// numbers, have one.
[[nodiscard]] std::optional<Vec3> common_point(const PosedSmooth& a, const PosedSmooth& b, const SmoothNearest& found,
                                               const PairFrame& frame);
[[nodiscard]] std::optional<Vec3> common_point(const PosedSmooth& a, const PosedConvex& b, const SmoothNearest& found,
                                               const PairFrame& frame);

}  // namespace toccata
