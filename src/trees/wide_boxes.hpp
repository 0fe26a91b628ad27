#pragma once

#include <array>
#include <cstddef>

#include "toccata/trees/wide_bvh.hpp"
#include "trees/float_box.hpp"

namespace toccata {

/// A box around what the lane's child may hold, in the coordinates of the items; rounded outwards.
[[nodiscard]] Aabb box_of(const WideBvh& tree, std::size_t block, std::size_t lane);

/// Makes the box the lane's, rounded outwards.
void set_box(WideBlock& block, std::size_t lane, const FloatBox& box);

/// The same for all lanes at once.
void set_boxes(WideBlock& block, const std::array<FloatBox, WideBlock::width>& boxes);

}  // namespace toccata
