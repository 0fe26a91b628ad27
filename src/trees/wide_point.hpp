#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "toccata/core/function_ref.hpp"
#include "toccata/core/index.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/leaf_triangles.hpp"
#include "trees/near_triangles.hpp"

namespace toccata {

/// A point in the units of a wide tree, from its origin. `pad` is a length that covers all that was rounded on the way
/// to these numbers; what the walk rounds itself is its own business (docs/methods/nearest-point.md).
struct WidePoint {
  Vec3 at;
  double pad = 0;
};

/// Calls `visit(places)` with items, at most WideBlock::width at once, whose boxes are no farther from the point than
/// the limit, told by their places in the tree's item order: near boxes before farther ones, as far as their blocks
/// tell. `visit` returns the limit from then on, in the tree's units. No item within it is left out. Returns how many
/// boxes were compared.
std::size_t walk_point(const WideBvh& tree, const WidePoint& point, double limit,
                       FunctionRef<double(std::span<const Index>)> visit);

/// What a walk compared.
struct PointCounts {
  std::size_t boxes = 0;
  std::size_t triangles = 0;
};

/// Coordinates of points may be so large for `find_near`: squares stay floats.
inline constexpr double greatest_near_coordinate = 0x1p30;

/// Finds the triangles that may be among the k nearest; lengths are in the tree's units, and limits and bounds are of
/// distances that differ from those of the tree's triangles and the point by at most `point.pad`, and 2⁻³⁵ of them.
PointCounts find_near(const WideBvh& tree, const LeafTriangles& leaves, const WidePoint& point, NearTriangles& near);

/// So many points walk at a time: enough to wait for memory together, and few enough that their stacks stay near.
inline constexpr std::size_t points_abreast = 6;

/// Where a walk of many begins.
struct NearStart {
  WidePoint point;
  float limit;
};

/// The same for the nearest of each of many points, of which a few walk at a time, a step each in turn: while one waits
/// for memory, another is worked on. Calls `done(i, near)` as each ends, with what it finds alone.
PointCounts find_near_each(const WideBvh& tree, const LeafTriangles& leaves, std::span<const NearStart> starts,
                           std::array<NearTriangles::Memory, points_abreast>& memory,
                           FunctionRef<void(std::size_t, NearTriangles&)> done);

}  // namespace toccata
