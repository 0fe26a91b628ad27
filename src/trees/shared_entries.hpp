#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>

#include "trees/wide_walk.hpp"

namespace toccata {

/// The entries of a frontier, shared out to the threads that walk on from them. Few at once, so that all end together.
class SharedEntries {
 public:
  /// The walk begins breadth first until there are so many: few enough that the beginning costs little, and many enough
  /// that all threads end together.
  static constexpr std::size_t wanted_per_thread = 128;

  explicit SharedEntries(const WideFrontier& from) : from_(from) {}

  /// How often they can be taken.
  [[nodiscard]] std::size_t shares() const { return (from_.size + at_once - 1) / at_once; }

  /// The next entries, as those of a frontier that has none left; says whether there were any.
  bool take(WideFrontier& to) {
    const std::size_t first = next_.fetch_add(at_once, std::memory_order_relaxed);
    if (first >= from_.size) return false;
    to.size = std::min(at_once, from_.size - first);
    for (auto [all, own] : {std::pair(&from_.blocks, &to.blocks), std::pair(&from_.boxes, &to.boxes)}) {
      if (own->size() < at_once) own->resize(at_once);
      std::copy_n(all->begin() + static_cast<std::ptrdiff_t>(first), to.size, own->begin());
    }
    return true;
  }

 private:
  static constexpr std::size_t at_once = 4;

  const WideFrontier& from_;
  std::atomic<std::size_t> next_ = 0;
};

}  // namespace toccata
