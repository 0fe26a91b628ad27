#include "query/scenes/candidate_pairs.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

#include "toccata/broad/broad_phase.hpp"

namespace toccata {

CandidatePairs::CandidatePairs(std::span<const Aabb> boxes, PairFilter wanted, std::span<const IndexPair> others,
                               int threads, std::size_t pairs_in_run)
    : boxes_(boxes),
      wanted_(std::move(wanted)),
      others_(others),
      threads_(threads),
      pairs_in_run_(pairs_in_run),
      counts_(boxes.size()) {
  count_by_first();
  count_ = std::accumulate(counts_.begin(), counts_.end(), others.size());
}

/// Every pair is refused, so that none is kept, and each is asked about once.
void CandidatePairs::count_by_first() {
  const PairFilter none = [this](const IndexPair& pair) {
    if (wanted_(pair)) std::atomic_ref(counts_[pair.first]).fetch_add(1, std::memory_order_relaxed);
    return false;
  };
  static_cast<void>(overlapping_pairs(boxes_, {.threads = threads_}, none));
}

std::vector<IndexPair> CandidatePairs::next() {
  std::vector<IndexPair> pairs;
  while (pairs.empty() && next_ < counts_.size()) {
    const std::size_t first = next_;
    std::size_t found = counts_[next_++];
    while (next_ < counts_.size() && found + counts_[next_] <= pairs_in_run_) found += counts_[next_++];
    const PairFilter of_run = [&](const IndexPair& pair) {
      return pair.first >= first && pair.first < next_ && wanted_(pair);
    };
    if (found > 0) pairs = overlapping_pairs(boxes_, {.threads = threads_}, of_run);
    add_others(pairs, next_);
  }
  return pairs;
}

/// Those of the boxes before `last`.
void CandidatePairs::add_others(std::vector<IndexPair>& pairs, std::size_t last) {
  const auto end =
      std::find_if(others_.begin(), others_.end(), [&](const IndexPair& pair) { return pair.first >= last; });
  const auto count = static_cast<std::size_t>(end - others_.begin());
  const auto middle = static_cast<std::ptrdiff_t>(pairs.size());
  pairs.insert(pairs.end(), others_.begin(), end);
  std::inplace_merge(pairs.begin(), pairs.begin() + middle, pairs.end());
  others_ = others_.subspan(count);
}

}  // namespace toccata
