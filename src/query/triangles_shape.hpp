#pragma once

#include <vector>

#include "query/posed_shape.hpp"
#include "toccata/query/relation.hpp"

// A posed mesh or height field against a shape that needs no tree. The tree finds the triangles near it; every pair of
// a triangle and the shape is decided exactly; of solid meshes winding numbers tell the rest.
namespace toccata {

[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedConvex& b);
[[nodiscard]] bool overlap(const PosedTriangles& a, const PosedHalfSpace& b);

/// The triangles that meet the shape, ascending.
[[nodiscard]] std::vector<Index> triangles_meeting(const PosedMesh& a, const PosedConvex& b);
[[nodiscard]] std::vector<Index> triangles_meeting(const PosedMesh& a, const PosedHalfSpace& b);

[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedConvex& b);
[[nodiscard]] Relation relation(const PosedTriangles& a, const PosedHalfSpace& b);

}  // namespace toccata
