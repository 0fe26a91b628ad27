#pragma once

#include <vector>

#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// The vertices of the shape itself, without its radius; in the world.
[[nodiscard]] inline std::vector<Vec3> vertices_of(const PosedPolytope& shape) {
  std::vector<Vec3> vertices;
  vertices.reserve(shape.vertex_count());
  for (Index i = 0; i < shape.vertex_count(); ++i) vertices.push_back(shape.vertex(i));
  return vertices;
}

}  // namespace toccata
