#pragma once

#include <span>
#include <string>

#include "toccata/core/function_ref.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// Why this is no tree over items with these boxes (none empty, all finite), in a few words; empty when it is one. A
/// tree without a fault keeps every promise of wide_bvh.hpp, and the items below each block lie side by side in the
/// order of items. Takes time in proportion to the number of items, whatever the tree holds.
[[nodiscard]] std::string fault_of(const WideBvh& tree, std::span<const Aabb> boxes);

/// The same of the boxes of a mesh's triangles.
[[nodiscard]] std::string fault_of(const WideBvh& tree, const TriangleMesh& mesh);

}  // namespace toccata
