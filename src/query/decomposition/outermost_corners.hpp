#pragma once

#include <span>
#include <vector>

#include "query/decomposition/exact_polygon.hpp"

namespace toccata {

/// Corners of which the convex hull is that of all corners of the polygons: without most of those that lie in a plane
/// among others that it made. Each once for every polygon that has it.
[[nodiscard]] std::vector<RationalPoint> outermost_corners(std::span<const ExactPolygon> polygons,
                                                           std::span<const CutPlane> planes);

}  // namespace toccata
