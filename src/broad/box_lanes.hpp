#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "broad/float_boxes.hpp"
#include "broad/pair_buffer.hpp"
#include "toccata/bounds/aabb.hpp"

// Boxes as floats, many at a time: what the methods that lay boxes side by side do most of. All pairs that are added
// overlap in doubles.
namespace toccata {

/// Boxes in columns, and what they stand for.
struct LaidOut {
  BoxColumns columns;
  const Aabb* boxes;  ///< by number
};

/// Each box from `begin` to `end` with those behind it, up to `ends[i - begin]`.
void add_overlaps_behind(const LaidOut& laid, std::size_t begin, std::size_t end, const std::uint32_t* ends,
                         PairBuffer& pairs);

/// The same, where each box is behind some of the lower sides of its tile, by a bit for each axis: a pair both of which
/// are behind the same side is told by another tile.
void add_overlaps_in_tile(const LaidOut& laid, const std::uint32_t* sides, std::size_t begin, std::size_t end,
                          const std::uint32_t* ends, PairBuffer& pairs);

/// A box, which is not among them, with those from `begin` to `end`.
void add_overlaps_with(const LaidOut& laid, const FlatBox& box, std::size_t begin, std::size_t end, PairBuffer& pairs);

/// Cells of a grid one behind the other, z fastest, then y. A box is in the cell of its lower corner, and reaches at
/// most into the next cell along each axis.
struct CellRows {
  LaidOut laid;
  const std::uint32_t* starts;  ///< of each cell; one more for the end
  std::uint32_t cells_x, cells_y, cells_z;
};

/// The pairs of boxes in cells from `begin` to `end` with each other and with those of the neighbours behind.
void add_overlaps_of_cells(const CellRows& rows, std::size_t begin, std::size_t end, PairBuffer& pairs);

/// A tree whose nodes are the boxes around every sixteen of the level below; level 0 are the boxes themselves. Behind
/// the last of each level there are boxes that overlap nothing, to the next sixteen.
struct BvhColumns {
  static constexpr std::size_t width = 16;
  static constexpr std::size_t most_levels = 8;
  std::array<BoxColumns, most_levels> levels;
  std::array<std::size_t, most_levels> sizes;
  std::size_t depth;
};

/// The pairs of boxes from `begin` to `end` with those behind them.
void add_overlaps_in_tree(const BvhColumns& tree, const Aabb* boxes, std::size_t begin, std::size_t end,
                          PairBuffer& pairs);

/// The pairs of boxes that are not in the tree with those that are. `all` are the boxes by number.
void add_overlaps_with_tree(const BvhColumns& tree, const Aabb* all, std::span<const FlatBox> boxes, PairBuffer& pairs);

}  // namespace toccata
