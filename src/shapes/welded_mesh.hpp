#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// The triangles of a mesh with vertices of equal coordinates (−0 equals 0) taken as one. Distinct vertices are
/// numbered in the order of their coordinates.
struct WeldedTriangles {
  std::vector<std::array<Index, 3>> triangles;
  std::size_t distinct_vertices = 0;
};

[[nodiscard]] WeldedTriangles weld(const TriangleMesh& mesh);

/// For each vertex, the first that has its coordinates.
[[nodiscard]] std::vector<Index> first_equal_vertices(const TriangleMesh& mesh);

/// An edge of a triangle of a welded mesh, from its corner of that number to the next.
struct WeldedEdge {
  Index low = 0;   ///< the lesser vertex
  Index high = 0;  ///< the greater; equal where two corners of the triangle are
  Index triangle = 0;
  Index corner = 0;
  bool upward = false;  ///< from low to high
};

/// All of them, ascending by (low, high, triangle, corner).
[[nodiscard]] std::vector<WeldedEdge> edges_of_triangles(const WeldedTriangles& welded);

/// The triangles that are connected through vertices.
[[nodiscard]] MeshParts connected_parts(const WeldedTriangles& welded);

/// An edge of a welded mesh, and how often triangles run along it. Triangles with two equal vertices have no edges.
struct EdgeUse {
  Index low = 0;             ///< the lesser vertex
  Index high = 0;            ///< the greater
  std::size_t upward = 0;    ///< uses from low to high
  std::size_t downward = 0;  ///< uses from high to low
};

/// All edges, ascending by (low, high).
[[nodiscard]] std::vector<EdgeUse> edge_uses(const WeldedTriangles& welded);

}  // namespace toccata
