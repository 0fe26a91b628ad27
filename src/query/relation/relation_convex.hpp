#pragma once

#include <span>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/query/relation.hpp"

// A solid mesh and a shape that some of its triangles meet, `contacts`, ascending. What each was taken for is left to
// the caller. Precondition: the mesh is closed and posed regularly.
namespace toccata {

/// The relation to a shape without radius: the hull of its vertices is made a mesh, exactly, and the meshes are asked.
[[nodiscard]] Relation relation_of_solid_and_polytope(const PosedMesh& solid, const PosedPolytope& shape);

/// The same for a shape with a radius, a quadric, or a half-space (docs/methods/relations-of-solids.md).
[[nodiscard]] Relation relation_of_solid_and_round(const PosedMesh& solid, const PosedPolytope& shape,
                                                   std::span<const Index> contacts);
[[nodiscard]] Relation relation_of_solid_and_round(const PosedMesh& solid, const PosedQuadric& shape,
                                                   std::span<const Index> contacts);
[[nodiscard]] Relation relation_of_solid_and_round(const PosedMesh& solid, const PosedHalfSpace& shape,
                                                   std::span<const Index> contacts);

}  // namespace toccata
