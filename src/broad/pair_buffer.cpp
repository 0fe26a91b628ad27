#include "broad/pair_buffer.hpp"

#include <bit>
#include <cstdint>

#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// First all pairs whose lesser numbers lie in the same range go side by side; then each range, small enough for the
/// nearest cache, is sorted by itself.
class PairSort {
 public:
  PairSort(std::span<const PairBuffer* const> buffers, std::size_t count, int threads)
      : buffers_(buffers), threads_(threads), shift_(shift_for(count, pair_count())), ranges_((count >> shift_) + 1) {}

  PairList sort(PairList storage) {
    count_ranges();
    resize_for_overwrite(storage, place_ranges());
    parallel_for(buffers_.size(), threads_, [&](std::size_t part) { scatter(part, storage); });
    parallel_for(ranges_, threads_, [&](std::size_t range) { sort_range(range, storage); });
    return storage;
  }

 private:
  static constexpr std::size_t pairs_in_range = 2048;
  static constexpr std::size_t most_ranges = 2048;

  [[nodiscard]] std::size_t pair_count() const {
    std::size_t sum = 0;
    for (const PairBuffer* buffer : buffers_) sum += buffer->size();
    return sum;
  }
  static int shift_for(std::size_t count, std::size_t pairs) {
    const std::size_t wanted = std::clamp<std::size_t>(pairs / pairs_in_range, 1, most_ranges);
    int shift = 0;
    while ((count >> shift) >= wanted) ++shift;
    return shift;
  }
  [[nodiscard]] std::size_t range_of(Index one, Index other) const { return std::min(one, other) >> shift_; }
  [[nodiscard]] std::size_t& place_of(std::size_t part, std::size_t range) { return places_[part * ranges_ + range]; }

  void count_ranges() {
    places_.assign(buffers_.size() * ranges_, 0);
    parallel_for(buffers_.size(), threads_, [&](std::size_t part) {
      std::size_t* counts = places_.data() + part * ranges_;
      for (const PairBuffer::Block& block : buffers_[part]->blocks())
        for (std::size_t i = 0; i < block.size; ++i) ++counts[range_of(block.ones()[i], block.others()[i])];
    });
  }
  std::size_t place_ranges() {
    starts_.assign(ranges_ + 1, 0);
    std::size_t sum = 0;
    for (std::size_t range = 0; range < ranges_; ++range) {
      starts_[range] = sum;
      for (std::size_t part = 0; part < buffers_.size(); ++part) sum += std::exchange(place_of(part, range), sum);
    }
    starts_[ranges_] = sum;
    return sum;
  }
  void scatter(std::size_t part, PairList& sorted) {
    std::size_t* places = places_.data() + part * ranges_;
    for (const PairBuffer::Block& block : buffers_[part]->blocks())
      for (std::size_t i = 0; i < block.size; ++i) {
        const Index one = block.ones()[i], other = block.others()[i];
        sorted[places[range_of(one, other)]++] = {std::min(one, other), std::max(one, other)};
      }
  }

  /// Sorts by counting the upper bits of the lesser numbers, so that few are in one bucket, and insertion does the
  /// rest.
  void sort_range(std::size_t range, PairList& sorted) const {
    const std::span<IndexPair> pairs = std::span(sorted).subspan(starts_[range], starts_[range + 1] - starts_[range]);
    if (pairs.size() <= few) return sort_few(pairs);
    const auto wanted = static_cast<int>(std::bit_width(pairs.size() / 2));
    const int bits = std::min(wanted, shift_), drop = shift_ - bits;
    const auto bucket_of = [&](const IndexPair& pair) { return (pair.first >> drop) & ((std::size_t{1} << bits) - 1); };
    std::vector<std::uint32_t> place((std::size_t{1} << bits) + 1, 0);
    for (const IndexPair& pair : pairs) ++place[bucket_of(pair) + 1];
    for (std::size_t i = 1; i < place.size(); ++i) place[i] += place[i - 1];
    const std::vector<IndexPair> copy(pairs.begin(), pairs.end());
    for (const IndexPair& pair : copy) pairs[place[bucket_of(pair)]++] = pair;
    // Each place is now the end of its bucket.
    for (std::size_t i = 0, begin = 0; i + 1 < place.size(); begin = place[i++])
      sort_few(pairs.subspan(begin, place[i] - begin));
  }
  static void sort_few(std::span<IndexPair> pairs) {
    const auto key = [](const IndexPair& pair) { return std::uint64_t{pair.first} << 32 | pair.second; };
    if (pairs.size() > few)
      return std::sort(pairs.begin(), pairs.end(),
                       [&](const IndexPair& a, const IndexPair& b) { return key(a) < key(b); });
    for (std::size_t i = 1; i < pairs.size(); ++i) {
      const IndexPair pair = pairs[i];
      std::size_t at = i;
      for (; at > 0 && key(pair) < key(pairs[at - 1]); --at) pairs[at] = pairs[at - 1];
      pairs[at] = pair;
    }
  }

  static constexpr std::size_t few = 24;
  std::span<const PairBuffer* const> buffers_;
  int threads_;
  int shift_;
  std::size_t ranges_;
  std::vector<std::size_t> places_;
  std::vector<std::size_t> starts_;
};

}  // namespace

PairList sorted_pairs(std::span<const PairBuffer* const> buffers, std::size_t count, int threads, PairList storage) {
  return PairSort(buffers, count, threads).sort(std::move(storage));
}

PairList sorted_pairs(std::span<const PairBuffer> buffers, std::size_t count, int threads, PairList storage) {
  std::vector<const PairBuffer*> each;
  for (const PairBuffer& buffer : buffers) each.push_back(&buffer);
  return sorted_pairs(each, count, threads, std::move(storage));
}

}  // namespace toccata
