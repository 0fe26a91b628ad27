#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/core/index_pair.hpp"
#include "toccata/trees/tree.hpp"

namespace toccata {

/// Boxes in a tree over them, asked one by one for what they overlap: so all pairs can be gone through in order without
/// being held at once.
class BoxIndex {
 public:
  /// The boxes are copied. None of their coordinates may be NaN; empty boxes overlap nothing.
  explicit BoxIndex(std::span<const Aabb> boxes);

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }

  /// The boxes of greater number that overlap box `number` (touching counts), ascending.
  [[nodiscard]] std::vector<Index> overlapping_after(Index number) const;

 private:
  std::vector<Aabb> boxes_;
  std::vector<Index> number_of_item_;  ///< the tree holds no empty boxes
  Tree<Aabb> tree_;
};

/// All pairs of boxes that overlap (touching counts), ascending, each once. Empty boxes overlap nothing. Memory is the
/// boxes' and the answer's.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes);

/// The same by testing every pair: the oracle.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs_by_brute_force(std::span<const Aabb> boxes);

}  // namespace toccata
