#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "math/constants.hpp"
#include "toccata/bounds/aabb.hpp"
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

/// The box around where a point is at a time, a multiple of a cell: 1 − time is exact then, so that two products and a
/// sum are off by less than 3 u of the greater magnitude; the box is wider by 8 u, which its own rounding takes one of.
/// At the time 0 it is the point.
[[nodiscard]] inline Aabb moment_box(const MovingPoint& point, double time) {
  if (time == 0) return {point.start, point.start};
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const double start = point.start[axis], end = point.end[axis], at = (1 - time) * start + time * end;
    const double off = 8 * unit_roundoff * std::max(std::fabs(start), std::fabs(end)) + 0x1p-1070;
    box.lower[axis] = at - off;
    box.upper[axis] = at + off;
  }
  return box;
}

/// What is in the first of the boxes at the start and moves in straight lines into the first at the end stays apart all
/// the way from what is so in the second ones: a difference of two coordinates that is positive at both ends is so in
/// between.
[[nodiscard]] inline bool stay_apart(const Aabb& a_start, const Aabb& b_start, const Aabb& a_end, const Aabb& b_end) {
  for (int axis = 0; axis < 3; ++axis)
    if ((a_start.lower[axis] > b_start.upper[axis] && a_end.lower[axis] > b_end.upper[axis]) ||
        (b_start.lower[axis] > a_start.upper[axis] && b_end.lower[axis] > a_end.upper[axis]))
      return true;
  return false;
}

}  // namespace toccata
