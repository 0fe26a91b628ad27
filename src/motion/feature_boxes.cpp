#include "motion/feature_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "toccata/bounds/aabb.hpp"
#include "trees/chunks.hpp"

namespace toccata {
namespace {

constexpr std::size_t vertices_boxed_at_once = 4096;

/// The box grown by half the separation on every side, and no less.
Aabb grown_by_half(Aabb box, double separation) {
  if (separation == 0) return box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = std::nextafter(box.lower[axis] - 0.5 * separation, -infinity);
    box.upper[axis] = std::nextafter(box.upper[axis] + 0.5 * separation, infinity);
  }
  return box;
}

}  // namespace

std::vector<VertexBoxes> vertex_boxes(const DeformingMesh& mesh, const WideFrame& frame, double separation,
                                      int threads) {
  std::vector<VertexBoxes> boxes(mesh.start().size());
  const Chunks chunks{boxes.size(), vertices_boxed_at_once};
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    const std::size_t first = chunks.first(chunk), last = std::min(first + chunks.piece, boxes.size());
    for (std::size_t v = first; v < last; ++v) {
      const Aabb start = merge(Aabb{}, mesh.start()[v]);
      boxes[v] = {to_frame(frame, grown_by_half(merge(start, mesh.end()[v]), separation)), to_frame(frame, start)};
    }
  });
  return boxes;
}

}  // namespace toccata
