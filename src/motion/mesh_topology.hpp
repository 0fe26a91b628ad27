#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"

namespace toccata {

/// What of a mesh stays the same while it deforms: its triangles, their edges, and which triangle answers for which
/// feature. Every vertex and every edge has one triangle that does; pairs of features are asked about where the
/// triangles that answer for them meet, so each pair once (S. Curtis, R. Tamstorf, D. Manocha, "Fast collision
/// detection for deformable models using representative-triangles", 2008). Few triangles answer for many: with the
/// others there is little to do.
struct MeshTopology {
  static constexpr Index no_edge = std::numeric_limits<Index>::max();

  struct alignas(32) OfTriangle {
    std::array<Index, 3> corner;
    std::array<Index, 3> edge{no_edge, no_edge, no_edge};  ///< from corner i to the next; none from a vertex to itself
    std::uint8_t own_vertices = 0;                         ///< bit i: it answers for corner i
    std::uint8_t own_edges = 0;                            ///< bit i: it answers for edge i
  };

  explicit MeshTopology(std::span<const std::array<Index, 3>> triangles_of_mesh);

  std::vector<std::array<Index, 3>> triangles;
  std::vector<IndexPair> edges;  ///< by their ends, ascending
  std::vector<OfTriangle> of_triangle;
};

}  // namespace toccata
