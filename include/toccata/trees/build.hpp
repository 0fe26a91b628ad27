#pragma once

#include <span>

#include "toccata/bounds/aabb.hpp"
#include "toccata/trees/bvh.hpp"

namespace toccata {

struct BuildOptions {
  Index leaf_size = 4;  ///< at most this many items in a leaf; at least 1
};

/// A hierarchy over items that are told by their boxes (item i has boxes[i]; none empty). Splits from the top down
/// where the surface-area heuristic is least among 16 slabs along the longest axis of the centres (J. Goldsmith, J.
/// Salmon, "Automatic creation of object hierarchies for ray tracing", 1987; I. Wald, "On fast construction of
/// SAH-based bounding volume hierarchies", 2007), and in halves where centres coincide. The same boxes give the same
/// tree.
[[nodiscard]] Bvh<Aabb> build_bvh(std::span<const Aabb> boxes, const BuildOptions& options = {});

}  // namespace toccata
