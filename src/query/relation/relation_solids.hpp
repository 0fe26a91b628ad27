#pragma once

#include "query/meshes/posed_mesh.hpp"
#include "query/relation/relation_posed.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

/// The relation of two solids. `visit` gives their contacts. Preconditions: both closed and posed regularly.
[[nodiscard]] Relation relation_of_solids(const PosedMesh& a, const PosedMesh& b, VisitContacts visit);

/// The relation of a solid and a surface: apart, touching or crossing; b_in_a when all of the surface is in the solid's
/// interior.
[[nodiscard]] Relation relation_of_solid_and_surface(const PosedMesh& solid, const PosedMesh& surface,
                                                     VisitContacts visit);

}  // namespace toccata
