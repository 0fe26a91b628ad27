#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "query/relation/relation_locality.hpp"

namespace toccata {

/// The first triangle of the first part of the mesh that is inside the solid, if there is one. The surfaces do not
/// meet, so every connected part of the mesh lies as a whole inside or outside.
[[nodiscard]] inline std::optional<Index> part_inside(const PosedMesh& mesh, const PosedMesh& solid) {
  const std::vector<Index>& parts = mesh.model().mesh_parts().first_triangle;
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](Index triangle) { return is_interior(mesh.triangle(triangle)[0], solid); });
  return found == parts.end() ? std::nullopt : std::optional(*found);
}

}  // namespace toccata
