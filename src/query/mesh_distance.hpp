#pragma once

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Distances of a posed mesh or height field (docs/methods/mesh-distance.md). Elements and faces are those of the
// meshes.
namespace toccata {

[[nodiscard]] Distance distance(const PosedTriangles& a, const PosedTriangles& b, SearchScratch& scratch);
[[nodiscard]] Distance distance(const PosedTriangles& a, const PosedConvex& b, SearchScratch& scratch);
[[nodiscard]] Distance distance(const PosedTriangles& a, const PosedHalfSpace& b, SearchScratch& scratch);

}  // namespace toccata
