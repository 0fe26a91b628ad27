#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// A block of a tree, and when its turn comes.
struct Pending {
  float when;
  std::int32_t block;
};

/// As much as the usual walk needs; a deeper one takes memory from elsewhere. After `make_room` there is room for a
/// block's children.
class PendingStack {
 public:
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const Pending& top() const { return place_[size_ - 1]; }
  Pending pop() { return place_[--size_]; }
  void make_room() {
    if (size_ + WideBlock::width > capacity_) grow();
  }
  /// At so many places beyond the last, for `claim` to take.
  void put(std::size_t beyond, const Pending& one) { place_[size_ + beyond] = one; }
  void claim(std::size_t count) { size_ += count; }
  /// Among the last `count`, so that the earliest comes last.
  void insert(const Pending& one, std::size_t count) {
    std::size_t at = size_++;
    for (; count > 0 && place_[at - 1].when < one.when; --at, --count) place_[at] = place_[at - 1];
    place_[at] = one;
  }

 private:
  void grow() {
    std::vector<Pending> more(2 * capacity_);
    std::copy_n(place_, size_, more.begin());
    further_ = std::move(more);
    place_ = further_.data();
    capacity_ = further_.size();
  }

  std::array<Pending, 256> first_;
  std::vector<Pending> further_;
  Pending* place_ = first_.data();
  std::size_t size_ = 0, capacity_ = first_.size();
};

}  // namespace toccata
