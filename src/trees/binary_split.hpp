#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "trees/float_box.hpp"

namespace toccata {

/// A run of items, and what is known of them together.
struct Part {
  FloatBox box;
  FloatBox middles;  ///< around twice the centres
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

struct SplitPart {
  Part left;
  Part right;
};

[[nodiscard]] Part part_of(std::span<const FloatItem> items, std::uint32_t first, std::uint32_t count);

/// Splits the run of items of a part (`items` are all items; those of the part are reordered): where the surface-area
/// heuristic is least, among slabs along the longest axis of the centres, or among all places when there are few items.
/// In halves where centres coincide. Areas count by the blocks of eight items that a side needs. At least 2 items.
[[nodiscard]] SplitPart split(std::span<FloatItem> items, const Part& part);

/// Splits in halves that are whole blocks of eight items.
[[nodiscard]] SplitPart split_in_halves(std::span<const FloatItem> items, const Part& part);

}  // namespace toccata
