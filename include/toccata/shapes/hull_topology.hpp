#pragma once

#include <span>

#include "toccata/core/index.hpp"

namespace toccata {

/// The boundary of a convex polytope as half-edges: every edge is two of them, one in each of its faces. A face is a
/// polygon whose half-edges turn counter-clockwise seen from outside. A flat polygon has two faces, its front and its
/// back; a segment has one face of two half-edges, which are each other's twin; a point has none.
struct HullTopology {
  std::span<const Index>
      face_start;                 ///< one more than faces: face f has the half-edges [face_start[f], face_start[f + 1])
  std::span<const Index> origin;  ///< of each half-edge, the vertex it starts at; the next of its face tells its end
  std::span<const Index> twin;    ///< of each half-edge, the same edge in the other face, the other way round
  std::span<const Index> face;    ///< of each half-edge, the face it belongs to
  std::span<const Index> leaving;  ///< of each vertex, a half-edge that starts at it
  /// Of a hull of 512 vertices or more: for each cell of a grid of directions a vertex that is far along them, where a
  /// walk to the farthest begins. Else empty.
  std::span<const Index> guide{};

  [[nodiscard]] Index face_count() const { return face_start.empty() ? 0 : static_cast<Index>(face_start.size() - 1); }
  [[nodiscard]] Index next(Index half_edge) const {
    const Index end = face_start[face[half_edge] + 1];
    return half_edge + 1 == end ? face_start[face[half_edge]] : half_edge + 1;
  }
  [[nodiscard]] Index target(Index half_edge) const { return origin[twin[half_edge]]; }
};

}  // namespace toccata
