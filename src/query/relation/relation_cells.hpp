#pragma once

#include <functional>
#include <span>

#include "query/inside/inside_point.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// What to do after a point of a cell was looked at.
enum class CellVisit {
  next,     ///< the point will do: go on to the next cell
  another,  ///< give another point of the same cell
  stop,
};

/// A coordinate axis along which the projection of `t` has area, the one along which it has most, as far as doubles
/// tell. Precondition: has_area(t).
[[nodiscard]] int projection_axis(const Triangle& t);

/// The cells of a triangle are the connected pieces that remain of its relative interior when the segments in which
/// the planes of other triangles cut it, and the edges of coplanar ones, are taken away. Calls `visit` with a point of
/// every cell, of some cells more than once, exactly; all points that it gives of one cell differ. False when `visit`
/// stopped it. It ends if `visit` asks for another point at finitely many points of a cell only, such as those in which
/// other triangles touch it. Preconditions: has_area(t); every triangle of `cuts` meets t.
bool visit_cells(const Triangle& t, std::span<const Triangle> cuts,
                 const std::function<CellVisit(const ExactPoint&)>& visit);

}  // namespace toccata
