#pragma once

#include <span>
#include <vector>

#include "query/posed_mesh.hpp"

namespace toccata {

/// The given triangles in sets that are connected through their vertices, those of equal world coordinates taken as
/// one. Ascending by the first triangle of each, and within each.
[[nodiscard]] std::vector<std::vector<Index>> connected_parts(const PosedMesh& mesh, std::span<const Index> triangles);

/// All triangles of the mesh, so.
[[nodiscard]] std::vector<std::vector<Index>> connected_parts(const PosedMesh& mesh);

/// Off all faces of the closed mesh, and its winding number there is not 0.
[[nodiscard]] bool is_interior(const Vec3& point, const PosedMesh& closed);

}  // namespace toccata
