#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/motion/deforming_mesh.hpp"
#include "trees/float_box.hpp"
#include "trees/wide_frame.hpp"

namespace toccata {

/// Boxes of floats around what a vertex passes, grown by half of a separation, and around where it starts. Those of
/// edges and faces are around the boxes of their vertices.
struct VertexBoxes {
  FloatBox way;
  FloatBox start;
};

/// For each vertex of the mesh; two meshes that are compared have one frame.
[[nodiscard]] std::vector<VertexBoxes> vertex_boxes(const DeformingMesh& mesh, const WideFrame& frame,
                                                    double separation, int threads);

inline FloatBox around(const FloatBox& a, const FloatBox& b) {
  return {least(a.lower, b.lower), greatest(a.upper, b.upper)};
}

/// The closed boxes have no point in common.
inline bool boxes_are_apart(const FloatBox& a, const FloatBox& b) {
  using Long2 [[gnu::vector_size(16)]] = std::int64_t;
  const Int4 beyond = (a.lower > b.upper) | (b.lower > a.upper);
  const Long2 halves = std::bit_cast<Long2>(beyond);
  return (halves[0] | halves[1]) != 0;
}

}  // namespace toccata
