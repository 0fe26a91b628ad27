#pragma once

#include <array>
#include <vector>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// What is out of order at a place of a mesh: what MeshHealth counts under the same name.
enum class MeshFaultKind {
  boundary_edges,
  non_manifold_edges,
  flipped_edges,
  degenerate_triangles,
  duplicate_triangles,
  unused_vertices,
};

/// Faults of one kind that hang together through vertices: the edges around one hole, say. All unused vertices are one.
struct MeshFault {
  MeshFaultKind kind{};
  std::vector<std::array<Index, 2>> edges;  ///< by their vertices, of which each is the first of those that are equal
  std::vector<Index> triangles;             ///< ascending
  std::vector<Index> vertices;              ///< ascending

  [[nodiscard]] std::size_t count() const { return edges.size() + triangles.size() + vertices.size(); }
};

/// Where the faults are that `inspect(mesh)` counts: by kind, then the larger first, then by their first vertex or
/// triangle. The counts of a kind add up to what `inspect` says.
[[nodiscard]] std::vector<MeshFault> mesh_faults(const TriangleMesh& mesh);

}  // namespace toccata
