#include "query/relation/hull_mesh.hpp"
#include "query/relation/relation_convex.hpp"
#include "query/relation/relation_posed.hpp"

namespace toccata {

Relation relation_of_solid_and_polytope(const PosedMesh& solid, const PosedPolytope& shape) {
  const HullMesh hull = hull_mesh(shape);
  const bool has_interior = hull.dimension == 3;
  if (shape.solid() && !has_interior) return {.kind = RelationKind::touching};
  const PosedMesh other(Model(hull.mesh), Pose{});
  SearchScratch scratch;
  if (shape.solid() == has_interior) return relation_of({solid, true}, {other, has_interior}, scratch);
  // Rounding has bent a flat hull: a surface with an interior of its own. Some point of it lies in the interior of the
  // solid exactly when the interiors meet.
  const Relation as_solids = relation_of({solid, true}, {other, true}, scratch);
  return {.kind = as_solids.kind == RelationKind::overlapping ? RelationKind::crossing : RelationKind::touching};
}

}  // namespace toccata
