#include "query/contact_order.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// Fewer contacts are not worth a second thread's while.
constexpr std::size_t worth_threads = 1024;

/// So many numbers per range are looked at to find ranges of about the same size.
constexpr std::size_t sampled_per_range = 64;

/// The numbers from `first` on that are less than `end`.
struct NumberRange {
  std::uint64_t first;
  std::uint64_t end;
  [[nodiscard]] bool contains(std::uint64_t number) const { return first <= number && number < end; }
};

/// What all parts of a search found.
class AllFound {
 public:
  explicit AllFound(const SearchScratch& scratch) : lists_{scratch.main.found.pairs} {
    for (const auto& part : scratch.others) lists_.emplace_back(part->found.pairs);
    for (const auto& list : lists_) size_ += list.size();
  }

  [[nodiscard]] std::size_t size() const { return size_; }

  /// Ranges of about the same size that hold all.
  [[nodiscard]] std::vector<NumberRange> ranges(std::size_t count) const {
    const std::vector<std::uint64_t> sample = ascending_sample(sampled_per_range * count);
    // No pair has the greatest number: a mesh has fewer triangles.
    std::vector<NumberRange> ranges{{0, std::numeric_limits<std::uint64_t>::max()}};
    for (std::size_t i = 1; i < count; ++i) {
      ranges.back().end = sample[i * sample.size() / count];
      ranges.push_back({ranges.back().end, std::numeric_limits<std::uint64_t>::max()});
    }
    return ranges;
  }

  struct Count {
    std::size_t before = 0;
    std::size_t within = 0;
  };
  [[nodiscard]] Count count(const NumberRange& range) const {
    Count count;
    each([&](const FoundPair& pair) {
      count.before += pair.number < range.first ? 1 : 0;
      count.within += range.contains(pair.number) ? 1 : 0;
    });
    return count;
  }

  /// Copies those in a range; `to` has room for one more. Without branches, which could not be foreseen.
  void copy(const NumberRange& range, std::span<FoundPair> to) const {
    std::size_t next = 0;
    each([&](const FoundPair& pair) {
      to[next] = pair;
      next += range.contains(pair.number) ? 1 : 0;
    });
  }

 private:
  template <class See>
  void each(const See& see) const {
    for (const auto& list : lists_)
      for (const FoundPair& pair : list) see(pair);
  }

  [[nodiscard]] std::vector<std::uint64_t> ascending_sample(std::size_t size) const {
    const std::size_t step = std::max<std::size_t>(1, size_ / size);
    std::vector<std::uint64_t> sample;
    for (const auto& list : lists_)
      for (std::size_t i = 0; i < list.size(); i += step) sample.push_back(list[i].number);
    std::sort(sample.begin(), sample.end());
    return sample;
  }

  std::vector<std::span<const FoundPair>> lists_;
  std::size_t size_ = 0;
};

/// The pairs of a range, ascending; they lie in the scratch.
std::span<const FoundPair> ascending_pairs(const AllFound& found, const NumberRange& range, std::size_t count,
                                           PairRange& scratch) {
  scratch.pairs.resize(count + 1);
  scratch.spare.resize(count + 1);
  found.copy(range, scratch.pairs);
  return sorted(std::span(scratch.pairs).first(count), std::span(scratch.spare).first(count));
}

}  // namespace

Contact contact_of(const PosedMesh& a, const PosedMesh& b, const FoundPair& pair) {
  const Index first = pair.first(), second = pair.second();
  return {first, second, a.model().mesh().face_of(first), b.model().mesh().face_of(second), *pair.meeting};
}

namespace {

/// What one thread found is put in order where it lies, so that nothing is allocated once the scratch has grown.
void order_alone(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  std::vector<FoundPair>& found = scratch.main.found.pairs;
  if (scratch.ranges.empty()) scratch.ranges.resize(1);
  std::vector<FoundPair>& spare = scratch.ranges.front().spare;
  if (spare.size() < found.size()) spare.resize(found.size());
  const auto pairs = sorted(found, std::span(spare).first(found.size()));
  scratch.contacts.resize(pairs.size());
  std::transform(pairs.begin(), pairs.end(), scratch.contacts.begin(),
                 [&](const FoundPair& pair) { return contact_of(a, b, pair); });
}

}  // namespace

void order_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int threads) {
  if (threads == 1) {
    order_alone(a, b, scratch);
    return;
  }
  const AllFound found(scratch);
  const bool alone = found.size() < worth_threads;
  const auto ranges = found.ranges(alone ? 1 : static_cast<std::size_t>(thread_count(threads)));
  if (scratch.ranges.size() < ranges.size()) scratch.ranges.resize(ranges.size());
  // Not cleared before: what is there need not be written twice.
  scratch.contacts.resize(found.size());
  parallel_for(ranges.size(), threads, [&](std::size_t i) {
    const auto [before, within] = found.count(ranges[i]);
    const auto pairs = ascending_pairs(found, ranges[i], within, scratch.ranges[i]);
    std::transform(pairs.begin(), pairs.end(), std::span(scratch.contacts).subspan(before).begin(),
                   [&](const FoundPair& pair) { return contact_of(a, b, pair); });
  });
}

}  // namespace toccata
