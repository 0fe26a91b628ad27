#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "broad/pair_finder.hpp"

namespace toccata {

/// Pairs as they are found: in no order, and either number first. Memory stays until the buffer goes.
class PairBuffer {
 public:
  void clear() { size_ = 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t bytes() const { return 2 * capacity_ * sizeof(Index); }
  [[nodiscard]] const Index* ones() const { return ones_.get(); }
  [[nodiscard]] const Index* others() const { return others_.get(); }

  /// Where the next `more` pairs may be written; `added` tells how many were.
  struct Place {
    Index* ones;
    Index* others;
  };
  [[nodiscard]] Place room_for(std::size_t more) {
    if (size_ + more > capacity_) grow(size_ + more);
    return {ones_.get() + size_, others_.get() + size_};
  }
  void added(std::size_t count) { size_ += count; }

  void add(Index one, Index other) {
    const Place place = room_for(1);
    *place.ones = one;
    *place.others = other;
    ++size_;
  }

 private:
  void grow(std::size_t needed) {
    const std::size_t capacity = std::max({needed, 2 * capacity_, std::size_t{256}});
    auto ones = std::make_unique_for_overwrite<Index[]>(capacity);
    auto others = std::make_unique_for_overwrite<Index[]>(capacity);
    std::copy_n(ones_.get(), size_, ones.get());
    std::copy_n(others_.get(), size_, others.get());
    ones_ = std::move(ones);
    others_ = std::move(others);
    capacity_ = capacity;
  }

  std::unique_ptr<Index[]> ones_, others_;
  std::size_t size_ = 0, capacity_ = 0;
};

/// All pairs of the buffers, ascending and the lesser number first, in the memory of `storage`. Each pair is in one
/// buffer, once. All numbers are below `count`.
[[nodiscard]] PairList sorted_pairs(std::span<const PairBuffer* const> buffers, std::size_t count, int threads,
                                    PairList storage);

[[nodiscard]] PairList sorted_pairs(std::span<const PairBuffer> buffers, std::size_t count, int threads,
                                    PairList storage);

/// Of the pairs before, those that stay, and the new ones between them, ascending, in the memory of `storage`. What is
/// new does not stay from before.
template <class Stays>
[[nodiscard]] PairList with_new_pairs(std::span<const IndexPair> before, std::span<const IndexPair> added,
                                      PairList storage, const Stays& stays) {
  storage.resize(before.size() + added.size());
  IndexPair* out = storage.data();
  auto next = added.begin();
  for (const IndexPair& pair : before) {
    while (next != added.end() && *next < pair) *out++ = *next++;
    *out = pair;
    out += stays(pair) ? 1 : 0;  // no branch: which stay is not to be foreseen
  }
  out = std::copy(next, added.end(), out);
  storage.resize(static_cast<std::size_t>(out - storage.data()));
  return storage;
}

/// Some of the numbers below `count`, split into parts that do not depend on how many threads there are.
struct Chunks {
  std::size_t count;
  std::size_t size;

  Chunks(std::size_t all, std::size_t parts) : count(all), size(std::max<std::size_t>(1, (all + parts - 1) / parts)) {}
  [[nodiscard]] std::size_t parts() const { return (count + size - 1) / size; }
  [[nodiscard]] std::size_t begin(std::size_t part) const { return std::min(part * size, count); }
  [[nodiscard]] std::size_t end(std::size_t part) const { return std::min((part + 1) * size, count); }
};

}  // namespace toccata
