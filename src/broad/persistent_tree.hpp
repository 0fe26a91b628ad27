#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "broad/pair_buffer.hpp"
#include "broad/pair_finder.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {

/// A tree that is kept between updates: each box that moved is put elsewhere in it and looked for, and pairs of two
/// that did not move are those of before. A `Bvh` has `build(boxes)`, `move(number, box)`, also of new and empty ones,
/// `inserted()`, how many have been put in since all was built, `each_overlap(box, waiting, found)`, `add_cells(cells)`
/// and `bytes()`.
template <class Bvh>
class PersistentTree final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    if (!is_built_ || 4 * now.changed.size() > now.boxes.size() || tree_.inserted() > now.boxes.size() / 2)
      tree_.build(now.boxes);
    else
      for (const Index number : now.changed) tree_.move(number, now.boxes[number]);
    is_built_ = true;
    has_moved_.assign(now.boxes.size(), 0);
    for (const Index number : now.changed) has_moved_[number] = 1;
    find_new(now);
    return with_new_pairs(now.before, new_pairs_, std::move(storage), [&](const IndexPair& pair) {
      return (has_moved_[pair.first] | has_moved_[pair.second]) == 0;
    });
  }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> /*boxes*/) const override {
    BroadPhaseCells cells;
    tree_.add_cells(cells);
    return cells;
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = tree_.bytes() + has_moved_.capacity() + new_pairs_.capacity() * sizeof(IndexPair);
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

 private:
  static constexpr std::size_t parts = 16;

  void find_new(const BoxesNow& now) {
    const EvenParts chunks(now.changed.size(), parts);
    parallel_for(parts, now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      std::vector<Index> waiting;
      for (std::size_t i = chunks.begin(part); i < chunks.end(part); ++i) {
        const Index number = now.changed[i];
        const Aabb& box = now.boxes[number];
        if (is_empty(box)) continue;
        tree_.each_overlap(box, waiting, [&](Index other) {
          // Two that both moved meet twice.
          if (other != number && (has_moved_[other] == 0 || number < other) && overlap(box, now.boxes[other]))
            found_[part].add(number, other);
        });
      }
    });
    new_pairs_ = sorted_pairs(found_, now.boxes.size(), now.threads, std::move(new_pairs_));
  }

  Bvh tree_;
  bool is_built_ = false;
  std::vector<std::uint8_t> has_moved_;  ///< by number
  std::vector<PairBuffer> found_{parts};
  PairList new_pairs_;
};

}  // namespace toccata
