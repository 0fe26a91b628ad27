#include "query/contacts/contact_order.hpp"

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

/// What all parts of a search found.
class AllFound {
 public:
  explicit AllFound(SearchScratch& scratch) : scratch_(scratch) {
    each_list([&](std::span<const FoundPair> list) { size_ += list.size(); });
  }

  [[nodiscard]] std::size_t size() const { return size_; }

  struct Count {
    std::size_t before = 0;
    std::size_t within = 0;
  };
  [[nodiscard]] Count count(const PairRange& range) const {
    Count count;
    each([&](const FoundPair& pair) {
      count.before += pair.number < range.first ? 1 : 0;
      count.within += range.contains(pair.number) ? 1 : 0;
    });
    return count;
  }

  /// Copies those in a range; `to` has room for one more. Without branches, which could not be foreseen.
  void copy(const PairRange& range, std::span<FoundPair> to) const {
    std::size_t next = 0;
    each([&](const FoundPair& pair) {
      to[next] = pair;
      next += range.contains(pair.number) ? 1 : 0;
    });
  }

  /// Every so many of a list.
  template <class See>
  void each_of_step(std::size_t step, const See& see) const {
    each_list([&](std::span<const FoundPair> list) {
      for (std::size_t i = 0; i < list.size(); i += step) see(list[i]);
    });
  }

 private:
  template <class See>
  void each_list(const See& see) const {
    see(std::span(scratch_.main->found.pairs));
    for (const auto& part : scratch_.others) see(std::span(part->found.pairs));
  }
  template <class See>
  void each(const See& see) const {
    each_list([&](std::span<const FoundPair> list) {
      for (const FoundPair& pair : list) see(pair);
    });
  }

  SearchScratch& scratch_;
  std::size_t size_ = 0;
};

/// The first ranges of the scratch, so many, are made to hold about as many pairs each and all together.
std::span<PairRange> divide(const AllFound& found, std::size_t count, SearchScratch& scratch) {
  std::vector<std::uint64_t>& sample = scratch.sample;
  sample.clear();
  found.each_of_step(std::max<std::size_t>(1, found.size() / (sampled_per_range * count)),
                     [&](const FoundPair& pair) { sample.push_back(pair.number); });
  std::sort(sample.begin(), sample.end());
  if (scratch.ranges.size() < count) scratch.ranges.resize(count);
  const auto ranges = std::span(scratch.ranges).first(count);
  for (std::size_t i = 0; i < count; ++i) {
    // No pair has the greatest number: a mesh has fewer triangles.
    ranges[i].first = i == 0 ? 0 : ranges[i - 1].end;
    ranges[i].end =
        i + 1 == count ? std::numeric_limits<std::uint64_t>::max() : sample[(i + 1) * sample.size() / count];
    // Which ranges they are depends on who found what: any of them may be as long as all.
    ranges[i].pairs.reserve(found.size() + 1);
    ranges[i].spare.reserve(found.size() + 1);
  }
  return ranges;
}

/// The pairs of a range, ascending; they lie in it.
std::span<const FoundPair> ascending_pairs(const AllFound& found, PairRange& range, std::size_t count) {
  range.pairs.resize(count + 1);
  range.spare.resize(count + 1);
  found.copy(range, range.pairs);
  return sorted(std::span(range.pairs).first(count), std::span(range.spare).first(count));
}

/// What one thread found is put in order where it lies.
void order_alone(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch) {
  std::vector<FoundPair>& found = scratch.main->found.pairs;
  if (scratch.ranges.empty()) scratch.ranges.resize(1);
  std::vector<FoundPair>& spare = scratch.ranges.front().spare;
  if (spare.size() < found.size()) spare.resize(found.size());
  const auto pairs = sorted(found, std::span(spare).first(found.size()));
  scratch.contacts.resize(pairs.size());
  std::transform(pairs.begin(), pairs.end(), scratch.contacts.begin(),
                 [&](const FoundPair& pair) { return contact_of(a, b, pair); });
}

}  // namespace

Contact contact_of(const PosedMesh& a, const PosedMesh& b, const FoundPair& pair) {
  const Index first = pair.first(), second = pair.second();
  return {first, second, a.model().mesh().face_of(first), b.model().mesh().face_of(second), *pair.intersection};
}

void order_contacts(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int threads) {
  if (threads == 1) {
    order_alone(a, b, scratch);
    return;
  }
  const AllFound found(scratch);
  const bool alone = found.size() < worth_threads;
  const auto ranges = divide(found, alone ? 1 : static_cast<std::size_t>(thread_count(threads)), scratch);
  // Not cleared before: what is there need not be written twice.
  scratch.contacts.resize(found.size());
  parallel_for(ranges.size(), threads, [&](std::size_t i) {
    const auto [before, within] = found.count(ranges[i]);
    const auto pairs = ascending_pairs(found, ranges[i], within);
    std::transform(pairs.begin(), pairs.end(), std::span(scratch.contacts).subspan(before).begin(),
                   [&](const FoundPair& pair) { return contact_of(a, b, pair); });
  });
}

}  // namespace toccata
