#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "broad/pair_finder.hpp"

namespace toccata {

/// Pairs as they are found: in no order, and either number first. They lie in blocks, so that nothing is copied when
/// there are more of them than ever. Blocks that were not used once go.
class PairBuffer {
 public:
  struct Block {
    std::unique_ptr<Index[]> numbers;  ///< `room` of either
    std::size_t room;
    std::size_t size = 0;
    [[nodiscard]] Index* ones() const { return numbers.get(); }
    [[nodiscard]] Index* others() const { return numbers.get() + room; }
  };

  /// With `wanted`, other pairs that are added go when their block is full, so that memory follows those that are
  /// wanted.
  void clear(const PairFilter* wanted) {
    blocks_.resize(used_);
    used_ = 0;
    wanted_ = wanted;
  }
  [[nodiscard]] std::size_t size() const {
    std::size_t sum = 0;
    for (const Block& block : blocks()) sum += block.size;
    return sum;
  }
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = blocks_.capacity() * sizeof(Block);
    for (const Block& block : blocks_) sum += 2 * block.room * sizeof(Index);
    return sum;
  }
  [[nodiscard]] std::span<const Block> blocks() const { return std::span(blocks_).first(used_); }

  /// Where at least the next `more` pairs may be written, at most `least_room`; `added` tells how many were.
  struct Place {
    Index* ones;
    Index* others;
    std::size_t room;
  };
  [[nodiscard]] Place room_for(std::size_t more) {
    if (used_ == 0 || blocks_[used_ - 1].size + more > blocks_[used_ - 1].room) make_room(more);
    const Block& block = blocks_[used_ - 1];
    return {block.ones() + block.size, block.others() + block.size, block.room - block.size};
  }
  void added(std::size_t count) {
    if (count > 0) blocks_[used_ - 1].size += count;
  }

  void add(Index one, Index other) {
    const Place place = room_for(1);
    *place.ones = one;
    *place.others = other;
    added(1);
  }

 private:
  static constexpr std::size_t least_room = 128, most_room = 4096;

  void make_room(std::size_t more) {
    if (wanted_ == nullptr || used_ == 0) return open_block();
    Block& block = blocks_[used_ - 1];
    drop_unwanted(block);
    // Half is left free: the pairs are not gone through again for a few more.
    if (block.size > block.room / 2 || block.size + more > block.room) open_block();
  }

  void drop_unwanted(Block& block) const {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < block.size; ++i) {
      const Index one = block.ones()[i], other = block.others()[i];
      block.ones()[kept] = one;
      block.others()[kept] = other;
      kept += (*wanted_)({std::min(one, other), std::max(one, other)}) ? 1 : 0;
    }
    block.size = kept;
  }

  void open_block() {
    if (used_ == blocks_.size()) {
      const std::size_t room = std::min(least_room << std::min<std::size_t>(used_, 16), most_room);
      blocks_.push_back({std::make_unique_for_overwrite<Index[]>(2 * room), room});
    }
    blocks_[used_++].size = 0;
  }

  std::vector<Block> blocks_;
  std::size_t used_ = 0;
  const PairFilter* wanted_ = nullptr;
};

/// What was in the list is lost where it has no room. It grows by little more than is asked, not by halves: many such
/// lists are as long as there are boxes.
template <class Item>
void resize_for_overwrite(std::vector<Item>& list, std::size_t size) {
  if (size > list.capacity()) {
    list.clear();
    list.reserve(size + size / 16);
  }
  list.resize(size);
}

/// All pairs of the buffers, ascending and the lesser number first, in the memory of `storage`. Each pair is in one
/// buffer, once. All numbers are below `count`.
[[nodiscard]] PairList sorted_pairs(std::span<const PairBuffer* const> buffers, std::size_t count, int threads,
                                    PairList storage);

[[nodiscard]] PairList sorted_pairs(std::span<const PairBuffer> buffers, std::size_t count, int threads,
                                    PairList storage);

/// The pairs before that stay, and the new ones between them, ascending, in the memory of `storage`. A new pair is none
/// that stays from before.
template <class Stays>
[[nodiscard]] PairList with_new_pairs(std::span<const IndexPair> before, std::span<const IndexPair> added,
                                      PairList storage, const Stays& stays) {
  resize_for_overwrite(storage, before.size() + added.size());
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
struct EvenParts {
  std::size_t count;
  std::size_t size;

  EvenParts(std::size_t all, std::size_t parts)
      : count(all), size(std::max<std::size_t>(1, (all + parts - 1) / parts)) {}
  [[nodiscard]] std::size_t parts() const { return (count + size - 1) / size; }
  [[nodiscard]] std::size_t begin(std::size_t part) const { return std::min(part * size, count); }
  [[nodiscard]] std::size_t end(std::size_t part) const { return std::min((part + 1) * size, count); }
};

}  // namespace toccata
