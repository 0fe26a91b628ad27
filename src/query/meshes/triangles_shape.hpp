#pragma once

#include <span>

#include "query/posed_shape.hpp"
#include "query/search_scratch.hpp"
#include "toccata/query/relation.hpp"

// A posed mesh or height field against a shape that needs no tree. The tree finds the triangles near it; every pair of
// a triangle and the shape is decided exactly; of solid meshes winding numbers tell the rest.
namespace toccata {

[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedConvex& b);
[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedHalfSpace& b);

/// The triangles that meet the shape, ascending; they lie in the scratch.
[[nodiscard]] std::span<const Index> triangles_meeting(const PosedMesh& a, const PosedConvex& b,
                                                       SearchScratch& scratch);
[[nodiscard]] std::span<const Index> triangles_meeting(const PosedMesh& a, const PosedHalfSpace& b,
                                                       SearchScratch& scratch);

[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedConvex& b);
[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedHalfSpace& b);

}  // namespace toccata
