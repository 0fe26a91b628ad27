#pragma once

#include <cstdint>
#include <span>

#include "trees/float_box.hpp"

namespace toccata {

/// A run of items or of cells, and what is known of them together.
struct Part {
  FloatBox box{};
  FloatBox middles{};       ///< around twice the centres
  std::uint32_t first = 0;  ///< in the run of all
  std::uint32_t count = 0;
  std::uint32_t items = 0;  ///< the cells' items together; of items their number
};

struct SplitPart {
  Part left;
  Part right;
};

[[nodiscard]] Part part_of(std::span<const FloatItem> items, std::uint32_t first, std::uint32_t count);
[[nodiscard]] Part part_of(std::span<const Cell> cells, std::uint32_t first, std::uint32_t count);

/// Splits a part of the run of all items or cells, of which it has at least 2, and reorders it. Where the surface-area
/// heuristic is least among 16 slabs along the longest axis of the centres, in halves where centres coincide. A few
/// items are sorted, and all places tried.
[[nodiscard]] SplitPart split(std::span<FloatItem> items, const Part& part);
[[nodiscard]] SplitPart split(std::span<Cell> cells, const Part& part);

/// Splits in halves that are whole blocks of eight, as the order is.
[[nodiscard]] SplitPart split_in_halves(std::span<const FloatItem> items, const Part& part);
[[nodiscard]] SplitPart split_in_halves(std::span<const Cell> cells, const Part& part);

}  // namespace toccata
