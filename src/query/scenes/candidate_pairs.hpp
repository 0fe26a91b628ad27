#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata {

/// Pairs of boxes that overlap and are wanted, and others that are given, all ascending and in runs: memory is that of
/// the boxes, however many pairs there are.
class CandidatePairs {
 public:
  /// `others` are ascending, first < second; the filter does not want them. The boxes are those of `overlapping_pairs`,
  /// and outlive this.
  CandidatePairs(std::span<const Aabb> boxes, PairFilter wanted, std::span<const IndexPair> others, int threads,
                 std::size_t pairs_in_run = std::size_t{1} << 20);

  [[nodiscard]] std::size_t count() const { return count_; }

  /// The next of them, up to `pairs_in_run` or those of one box, besides the others; empty when all have been.
  [[nodiscard]] std::vector<IndexPair> next();

 private:
  void count_by_first();
  void add_others(std::vector<IndexPair>& pairs, std::size_t last);

  std::span<const Aabb> boxes_;
  PairFilter wanted_;
  std::span<const IndexPair> others_;  ///< those that have not been
  int threads_;
  std::size_t pairs_in_run_;
  std::vector<std::uint32_t> counts_;  ///< of the pairs of each box with later ones
  std::size_t count_;
  std::size_t next_ = 0;  ///< the first box of the next run
};

}  // namespace toccata
