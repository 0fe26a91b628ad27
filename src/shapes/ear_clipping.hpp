#pragma once

#include <array>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {

/// Three corners of a polygon, as positions 0 … n − 1 in it.
using CornerTriangle = std::array<Index, 3>;

/// Cuts a counter-clockwise polygon of n ≥ 3 corners into exactly n − 2 triangles, none of them clockwise. The result
/// is empty when the polygon allows no such cutting: it crosses itself, has no area or is clockwise. Corners may repeat
/// (a hole joined by a bridge) and lie on a line. Deterministic; time O(n · r) with r corners that are not convex.
///
/// Triangles that are all counter-clockwise and add up to the polygon cannot overlap: their winding numbers add up to
/// the polygon's, which is 0 or 1. So whatever order ears are cut in, a result that is not empty is right.
[[nodiscard]] std::vector<CornerTriangle> clip_ears(std::span<const Vec2> polygon);

}  // namespace toccata
