#pragma once

#include "query/meshes/posed_mesh.hpp"

namespace toccata {

/// −1 for a solid that is inside out, so that its triangles' normals point inwards: a mirrored one, for example. The
/// sign of its winding number inside tells, and beside one of its triangles is the inside.
[[nodiscard]] double outward_turn(const PosedMesh& mesh, Index triangle);

}  // namespace toccata
