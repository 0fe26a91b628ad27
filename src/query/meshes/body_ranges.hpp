#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "query/meshes/cull_bounds.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// What lies between two planes across a direction, which is of length 1 but for rounding.
struct RangeAlong {
  Vec3 direction{};
  FormRange range{};
};

/// The points of a region, or of a body, are in the ranges along up to three directions, but for the rounding of a few
/// products and sums of numbers that are no greater than `reach`, coordinate by coordinate (docs/design/culling.md).
struct RegionRanges {
  std::array<RangeAlong, 3> ranges{};
  std::size_t count = 0;
  Vec3 reach{};

  [[nodiscard]] std::span<const RangeAlong> all() const { return {ranges.data(), count}; }
};

// Directions at right angles or nearly so, along which a body is narrow where its box is wide, as a rod is that lies
// across the axes. None of a body that they tell little more about than its box does, which is around it in the world.

[[nodiscard]] RegionRanges ranges_of(const PosedPolytope& body, const Aabb& box);
[[nodiscard]] RegionRanges ranges_of(const PosedQuadric& body, const Aabb& box);

}  // namespace toccata
