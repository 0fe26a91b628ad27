#pragma once

#include <functional>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index_pair.hpp"

namespace toccata {

/// Which pairs are wanted: the same answer each time, from many threads at once.
using PairFilter = std::function<bool(const IndexPair&)>;

/// All pairs of boxes that overlap (touching counts), ascending, each once. Empty boxes (`Aabb{}`) overlap nothing.
/// Throws Error naming a box of which a side is no number, or has its lower end above the upper one.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes);

/// The same by testing every pair: the oracle.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs_by_brute_force(std::span<const Aabb> boxes);

}  // namespace toccata
