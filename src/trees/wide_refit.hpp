#pragma once

#include <array>
#include <span>

#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// `refit` for triangles whose corners move in straight lines, vertex v from start[v] to end[v]: boxes around all that
/// a triangle passes. (A point of it lies at every time between the corners' two boxes, so around these is enough.)
Refit refit_to_ways(WideBvh& tree, std::span<const std::array<Index, 3>> triangles, std::span<const Vec3> start,
                    std::span<const Vec3> end, int threads = own_thread);

}  // namespace toccata
