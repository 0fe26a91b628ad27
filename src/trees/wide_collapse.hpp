#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/trees/wide_bvh.hpp"
#include "trees/float_box.hpp"

namespace toccata {

/// A node of a binary tree that is to become a tree of eight children a node. With it the least cost of what is below
/// it when it may take up to 1, 2, … 8 lanes of a block: the sum of the areas of the blocks (H. Ylitie, T. Karras, S.
/// Laine, "Efficient incoherent ray traversal on GPUs through compressed wide BVHs", 2017, section 3.1).
struct BinaryNode {
  /// The count of a node whose block is made elsewhere; `first` is the number of that block.
  static constexpr std::uint32_t made_elsewhere = 0xffffffff;

  FloatBox box{};
  std::uint32_t first = 0;
  std::uint32_t count = 0;  ///< items
  std::uint32_t children =
      0;  ///< the left one's node, the right one's comes after it; 0 where there are at most 8 items
  std::array<float, WideBlock::width> cost{};
  /// With this many lanes (less one), how many the left child gets; 0 where the node takes one lane as a block.
  std::array<std::uint8_t, WideBlock::width> left_lanes{};

  [[nodiscard]] bool is_bottom() const { return children == 0; }
};

/// Fills in the costs of all nodes; children come after their parents.
void set_costs(std::span<BinaryNode> nodes);

/// Which node a block replaces, and the block of its first child that is made here; the others' follow.
struct BlockPlan {
  std::uint32_t node;
  std::uint32_t first_child;
};

/// The blocks that replace a binary tree whose costs are set and whose node 0, the root, is made here. Children lie
/// side by side, after their parent, and what is below the first of them before what is below the next.
[[nodiscard]] std::vector<BlockPlan> plan_blocks(std::span<const BinaryNode> nodes);

/// Makes the blocks planned, which are zero yet.
void fill_blocks(std::span<WideBlock> blocks, std::span<const BlockPlan> plans, std::span<const BinaryNode> nodes,
                 std::span<const FloatItem> items);

}  // namespace toccata
