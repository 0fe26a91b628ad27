#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "broad/box_sweep.hpp"
#include "broad/packed_bvh.hpp"

namespace toccata {

/// The boxes of a method by cells that are too large for its cells. They are compared with each other in a sweep, and
/// with the ordinary ones in a tree over these, which is made only where there are large ones.
class LargeBoxes {
 public:
  void clear() {
    large_.clear();
    ordinary_.clear();
  }
  void add_large(const FlatBox& box) { large_.push_back(box); }
  void add_ordinary(const FlatBox& box) { ordinary_.push_back(box); }

  /// `boxes` are all by number.
  void add_pairs(std::span<const Aabb> boxes, PairBuffer& pairs) {
    if (large_.empty()) return;
    sweep_.lay_out(large_, sweep_axis(large_));
    sweep_.add_pairs(boxes, 0, large_.size(), pairs);
    tree_.build(ordinary_, PackingOrder::morton);
    tree_.add_pairs_with(boxes.data(), large_, pairs);
  }

  [[nodiscard]] std::size_t bytes() const {
    return (large_.capacity() + ordinary_.capacity()) * sizeof(FlatBox) + tree_.bytes() + sweep_.bytes();
  }

 private:
  std::vector<FlatBox> large_, ordinary_;
  PackedBvh tree_;
  BoxSweep sweep_;
};

}  // namespace toccata
