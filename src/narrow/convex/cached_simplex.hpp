#pragma once

#include <algorithm>

#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// Where the last question with the workspace ended; empty unless it makes sense for these shapes, which may be others.
inline VertexPairs cached_simplex(const SimplexCache& workspace, const PosedPolytope& a, const PosedPolytope& b) {
  VertexPairs simplex;
  for (int i = 0; i < std::min(workspace.simplex_size, 4); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (workspace.vertex_a[at] >= a.vertex_count() || workspace.vertex_b[at] >= b.vertex_count()) return {};
    simplex.append(workspace.vertex_a[at], workspace.vertex_b[at]);
  }
  return simplex;
}

}  // namespace toccata
