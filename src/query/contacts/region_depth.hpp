#pragma once

#include <array>
#include <span>
#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "shapes/welded_mesh.hpp"

namespace toccata {

/// A mesh as a graph: from its vertices, those of equal coordinates taken as one, to its triangles.
class VertexGraph {
 public:
  explicit VertexGraph(const PosedMesh& mesh);

  [[nodiscard]] const std::array<Index, 3>& corners(Index triangle) const { return welded_.triangles[triangle]; }

  /// The vertices inside the solid that are connected through such with one of these triangles, in the world.
  [[nodiscard]] std::vector<Vec3> inside(const PosedMesh& solid, std::span<const Index> triangles) const;

 private:
  [[nodiscard]] std::span<const Index> triangles_at(Index vertex) const {
    return {around_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
  }

  const PosedMesh& mesh_;
  WeldedTriangles welded_;
  std::vector<Index> representative_;  ///< a vertex of the mesh for each distinct one
  std::vector<std::size_t> first_;     ///< of each vertex, in `around_`
  std::vector<Index> around_;          ///< triangles
};

}  // namespace toccata
