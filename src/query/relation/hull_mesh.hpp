#pragma once

#include <memory>

#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// The hull of a shape's world vertices, exactly, as triangles. Its radius is left aside.
struct HullMesh {
  std::shared_ptr<const TriangleMesh> mesh;  ///< closed when the dimension is 3, else each point of the hull once
  int dimension = 0;                         ///< of the hull in the world
};

[[nodiscard]] HullMesh hull_mesh(const PosedPolytope& shape);

}  // namespace toccata
