#pragma once

#include "query/meshes/posed_mesh.hpp"
#include "query/volume/volume_bracket.hpp"

namespace toccata {

/// The volume that any two closed meshes share, by cells of the box that both boxes have in common: halved as long as a
/// surface passes through them, up to a number of cells. What is certainly in both, and that with what may be.
[[nodiscard]] VolumeBracket volume_by_cells(const PosedMesh& a, const PosedMesh& b);

}  // namespace toccata
