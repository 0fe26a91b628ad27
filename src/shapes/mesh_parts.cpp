#include "toccata/shapes/triangle_mesh.hpp"

#include "shapes/welded_mesh.hpp"

namespace toccata {

MeshParts mesh_parts(const TriangleMesh& mesh) { return connected_parts(weld(mesh)); }

}  // namespace toccata
