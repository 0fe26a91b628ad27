#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {

/// Corners in a row, by their numbers, the last joined with the first.
using CornerLoop = std::vector<Index>;

/// Directed edges of a plane, of which as many lead to each point as from it, put together into loops: at a point of
/// several each turns left as sharply as it can.
[[nodiscard]] std::vector<CornerLoop> loops_of_edges(std::span<const Vec2> points,
                                                     std::span<const std::array<Index, 2>> edges);

/// Cuts what loops bound into triangles: counter-clockwise loops around it, clockwise ones around its holes. Holes are
/// joined to what is around them by bridges (D. Eberly, "Triangulation by ear clipping", 2002). No triangle is
/// clockwise, and the result right (ear_clipping.hpp), where that can be; where rounding made loops cross each other or
/// themselves, clockwise triangles have no more area than `negligible` together, and so little may be covered twice.
/// Nothing where no such cutting was found.
[[nodiscard]] std::optional<std::vector<std::array<Index, 3>>> cut_loops(std::span<const Vec2> points,
                                                                         std::span<const CornerLoop> loops,
                                                                         double negligible);

/// The area that a loop winds around, with its sign, rounded.
[[nodiscard]] double loop_area(std::span<const Vec2> points, const CornerLoop& loop);

}  // namespace toccata
