#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "query/relation/relation_locality.hpp"

namespace toccata {

/// Of a mesh whose surface does not meet that of the solid, so that every connected part of it lies as a whole inside
/// or outside: the first triangle of the first part inside, if there is one.
[[nodiscard]] inline std::optional<Index> part_inside(const PosedMesh& mesh, const PosedMesh& solid) {
  const std::vector<Index>& parts = mesh.model().mesh_parts().first_triangle;
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](Index triangle) { return is_interior(mesh.triangle(triangle)[0], solid); });
  return found == parts.end() ? std::nullopt : std::optional(*found);
}

}  // namespace toccata
