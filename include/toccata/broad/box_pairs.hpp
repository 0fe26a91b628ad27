#pragma once

#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"

namespace toccata {

/// Two different objects, first < second.
struct IndexPair {
  Index first;
  Index second;
  friend constexpr auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

/// All pairs of boxes that overlap (touching counts), ascending, each once. Empty boxes overlap nothing. Sorts the
/// boxes along the axis on which they spread most and sweeps them; memory is the boxes' and the answer's.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes);

/// The same by testing every pair: the oracle.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs_by_brute_force(std::span<const Aabb> boxes);

}  // namespace toccata
