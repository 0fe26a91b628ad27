#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// Triangles that may be among the k nearest of a point, by bounds of their distances.
class NearTriangles {
 public:
  struct Memory {
    std::vector<float> lowers;
    std::vector<Index> numbers;
    std::vector<float> uppers;  ///< a heap of the k least, the greatest first
  };

  /// What is certainly farther than the limit is of no interest.
  NearTriangles(std::size_t k, float limit, Memory& memory) : k_(k), limit_(limit), memory_(memory) {
    memory_.uppers.clear();
    if (memory_.lowers.empty()) grow();
  }

  [[nodiscard]] std::size_t k() const { return k_; }
  [[nodiscard]] float limit() const { return limit_; }

  /// There are k triangles that are no farther.
  void lower_limit(float upper) { limit_ = std::min(limit_, upper); }

  /// There is one.
  void see_upper(float upper) {
    std::vector<float>& uppers = memory_.uppers;
    if (uppers.size() == k_) {
      if (upper >= uppers.front()) return;
      std::pop_heap(uppers.begin(), uppers.end());
      uppers.back() = upper;
    } else {
      uppers.push_back(upper);
    }
    std::push_heap(uppers.begin(), uppers.end());
    if (uppers.size() == k_) lower_limit(uppers.front());
  }

  /// After this a block's worth of lower bounds and numbers may be written at the two places, for `claim` to take.
  void make_room() {
    if (count_ + WideBlock::width > memory_.lowers.size()) grow();
  }
  [[nodiscard]] float* lowers_place() { return memory_.lowers.data() + count_; }
  [[nodiscard]] Index* numbers_place() { return memory_.numbers.data() + count_; }
  void claim(std::size_t count) { count_ += count; }

  /// The numbers of those that are still of interest.
  [[nodiscard]] std::span<const Index> those_left() {
    std::size_t left = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      memory_.numbers[left] = memory_.numbers[i];
      memory_.lowers[left] = memory_.lowers[i];
      if (!(memory_.lowers[i] > limit_)) ++left;
    }
    count_ = left;
    return std::span(memory_.numbers).first(left);
  }

 private:
  void grow() {
    const std::size_t more = std::max<std::size_t>(64, 2 * memory_.lowers.size());
    memory_.lowers.resize(more);
    memory_.numbers.resize(more);
  }

  std::size_t k_;
  float limit_;
  std::size_t count_ = 0;
  Memory& memory_;
};

}  // namespace toccata
