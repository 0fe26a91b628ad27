#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "toccata/math/vec3.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// What a mesh is, counted exactly and repaired never. Vertices of equal coordinates are taken as one.
struct MeshHealth {
  std::size_t vertices = 0;           ///< as stored
  std::size_t distinct_vertices = 0;  ///< after taking equal coordinates as one
  std::size_t unused_vertices = 0;    ///< stored but in no triangle
  std::size_t triangles = 0;
  std::size_t faces = 0;
  std::size_t components = 0;            ///< parts connected through vertices
  std::size_t unbalanced_edges = 0;      ///< used unequally often in the two directions; 0 means closed
  std::size_t boundary_edges = 0;        ///< used by exactly one triangle
  std::size_t non_manifold_edges = 0;    ///< used by more than two triangles
  std::size_t flipped_edges = 0;         ///< used by two triangles, both in the same direction
  std::size_t degenerate_triangles = 0;  ///< without area, exactly
  std::size_t duplicate_triangles = 0;   ///< the same three vertices as an earlier one, in any order
  bool closed = false;                   ///< every edge is used equally in both directions: may be a solid
  double signed_volume = 0;              ///< of a closed mesh, rounded; negative when it is inside out; else 0
  Vec3 lower;                            ///< the least corner of the box around all used vertices, in file units
  Vec3 upper;                            ///< its greatest corner
};

[[nodiscard]] MeshHealth inspect(const TriangleMesh& mesh);

/// Every edge is used equally in both directions (vertices of equal coordinates taken as one).
[[nodiscard]] bool is_closed(const TriangleMesh& mesh);

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
