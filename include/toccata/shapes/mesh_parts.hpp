#pragma once

#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// The parts of a mesh: triangles that are connected through vertices, those of equal coordinates taken as one.
struct MeshParts {
  std::vector<Index> part_of_triangle;
  std::vector<Index> first_triangle;  ///< the least of each part, ascending
};

[[nodiscard]] MeshParts mesh_parts(const TriangleMesh& mesh);

}  // namespace toccata
