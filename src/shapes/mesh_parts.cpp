#include "toccata/shapes/mesh_parts.hpp"

#include "shapes/welded_mesh.hpp"

namespace toccata {

MeshParts mesh_parts(const TriangleMesh& mesh) { return connected_parts(weld(mesh)); }

}  // namespace toccata
