#pragma once

#include <cstddef>

#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// What refitting did. Once the nodes have grown to twice what they were when the tree was built, walks visit about
/// twice as many, and building anew pays.
struct Refit {
  std::size_t volumes_updated = 0;
  double growth = 1;  ///< of half_area, as `built_size` tells it, relative to the tree as built; +∞ where it was 0
  [[nodiscard]] bool should_rebuild() const { return !(growth <= 2); }
};

/// Puts the boxes of a tree over the mesh's triangles around them after its vertices have moved; which triangles lie
/// below which box stays. On up to `threads` threads (0: as many as the machine has), whatever they are the same tree.
/// Throws Error when the tree was built over another number of triangles. To do it for a model: Model::deform.
Refit refit(WideBvh& tree, const TriangleMesh& mesh, int threads = 1);

}  // namespace toccata
