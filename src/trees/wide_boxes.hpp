#pragma once

#include <cstddef>

#include "toccata/trees/wide_tree.hpp"

namespace toccata {

/// A box around what the lane's child may hold, in the coordinates of the items; rounded outwards.
[[nodiscard]] Aabb box_of(const WideTree& tree, std::size_t block, std::size_t lane);

}  // namespace toccata
