#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"

namespace toccata {

/// How the boxes of a full node are shared by two: the order, and how many of it go to the first.
struct NodeSplit {
  std::vector<Index> order;
  std::size_t first;
};

/// Along the axis on which the sums of the sides of both parts, over all ways to share, are least, that way whose parts
/// overlap least, of equal ones that with the least areas. Each gets at least `least`. (N. Beckmann et al., "The
/// R*-tree: an efficient and robust access method for points and rectangles", 1990, section 4.2.)
[[nodiscard]] NodeSplit split_of(std::span<const Aabb> boxes, std::size_t least);

/// Sorts numbers into `tiles.size() - 1` tiles, of which tile i holds those in places [tiles[i], tiles[i + 1]): all in
/// two halves along the axis on which the boxes' middles are spread most, and these again. (T. Lee, S. Lee, "OMT:
/// overlap minimizing top-down bulk loading algorithm for R-tree", 2003, cuts alike; slabs along one axis after the
/// other, as in S. T. Leutenegger et al., "STR", 1997, overlap more on surfaces.)
void sort_into_tiles(std::span<const Aabb> boxes, std::span<Index> numbers, std::span<const std::size_t> tiles);

}  // namespace toccata
