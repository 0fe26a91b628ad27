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

/// A point of the shape without its radius, most often an inner one; rounded, in the world.
[[nodiscard]] inline Vec3 middle_of(const PosedPolytope& shape) {
  return 0.5 * shape.vertex(0) + 0.5 * shape.vertex(shape.vertex_count() - 1);
}

/// The place in the world from which searches look at the shape: its own origin, where it must have come with a pose. A
/// ball, a capsule and a triangle may also be given by world coordinates; for every form of a question to have an
/// answer of the same bits, nothing of theirs is read but the vertices.
[[nodiscard]] inline Vec3 place_of(const PosedPolytope& shape) {
  return shape.vertex_count() > 3 ? shape.pose().offset : middle_of(shape);
}

}  // namespace toccata
