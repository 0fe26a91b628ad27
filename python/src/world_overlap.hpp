#pragma once

#include <toccata/world/world_queries.hpp>

namespace toccata::python {

/// Whether any two of the bodies have a point in common, found by the boxes alone: without a tree around them, which
/// takes longer to make than few bodies take to be asked. Stops at the first two.
[[nodiscard]] bool any_overlap_of_few(const World& world);

/// The same with the tree, which is up to date.
[[nodiscard]] bool any_overlap(const ObjectQueries<WorldBodies>& queries);

}  // namespace toccata::python
