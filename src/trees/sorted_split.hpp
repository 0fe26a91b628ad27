#pragma once

#include <cstdint>
#include <span>

#include "trees/binary_split.hpp"

namespace toccata {

constexpr std::uint32_t most_sorted = 32;

/// Sorts up to `most_sorted` items of a part along the axis where they can be split at the least cost. Returns how many
/// of them are the left side then.
[[nodiscard]] std::uint32_t sort_for_split(std::span<FloatItem> items, const Part& part);

}  // namespace toccata
