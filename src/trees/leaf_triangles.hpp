#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/ray_frame.hpp"

namespace toccata {

/// The triangles that are items of a block of a wide tree, side by side as its boxes are, in the tree's units from its
/// origin. A lane that is no item holds zeros.
struct alignas(64) TriangleLanes {
  std::array<std::array<std::array<float, WideBlock::width>, 3>, 3> corner;  ///< [corner][axis][lane]
  std::array<Index, WideBlock::width> number;                                ///< of the triangle in the mesh
};

/// The triangles of a mesh where its tree's blocks have them, so that a walk finds them without looking up numbers and
/// vertices; 320 bytes a block, about 53 a triangle.
struct LeafTriangles {
  std::vector<TriangleLanes> of_block;  ///< as many as the tree has blocks

  /// How much a coordinate differs at most from the vertex's exact one, in the tree's units: half of the last place of
  /// floats up to 1 (or 2, where the tree is larger than 2¹⁰²³), and what doubles round on the way.
  float off = 0;

  /// How rays come to them where the mesh is at the identity; of those that a model holds.
  RayFrame at_identity;
};

[[nodiscard]] LeafTriangles leaf_triangles(const WideBvh& tree, const TriangleMesh& mesh);

}  // namespace toccata
