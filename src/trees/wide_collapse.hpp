#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/trees/wide_tree.hpp"
#include "trees/float_box.hpp"

namespace toccata {

/// A node of a binary tree that is to become a tree of eight children a node. With it the least cost of what is below
/// it when it may take up to 1, 2, … 8 lanes of a block: the sum of the areas of the blocks (H. Ylitie, T. Karras, S.
/// Laine, "Efficient incoherent ray traversal on GPUs through compressed wide BVHs", 2017, section 3.1).
struct BinaryNode {
  FloatBox box;
  std::uint32_t first = 0;
  std::uint32_t count = 0;  ///< items
  std::uint32_t children =
      0;  ///< the left one's node, the right one's comes after it; 0 where there are at most 8 items
  std::array<float, WideBlock::width> cost{};
  /// With this many lanes (less one), how many the left child gets; 0 where the node takes one lane as a block.
  std::array<std::uint8_t, WideBlock::width> left_lanes{};

  [[nodiscard]] bool is_bottom() const { return children == 0; }
};

/// Fills in the costs, given those of the children.
void set_cost(BinaryNode& node, std::span<const BinaryNode> nodes);

/// The blocks that replace a binary tree (node 0 is the root; costs are set), its items in their order.
[[nodiscard]] std::vector<WideBlock> collapse(std::span<const BinaryNode> nodes, std::span<const FloatItem> items,
                                              int threads);

}  // namespace toccata
