#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad/box_lanes.hpp"

namespace toccata {

/// The axis along which the boxes are spread out most, measured by their sizes: along which fewest lie side by side.
[[nodiscard]] std::size_t sweep_axis(std::span<const FlatBox> boxes);

/// Boxes in the order of their lower ends along an axis: each can overlap only those behind it until the first that
/// begins behind its upper end.
class BoxSweep {
 public:
  void lay_out(std::span<const FlatBox> boxes, std::size_t axis);
  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] std::size_t axis() const { return axis_; }
  /// The pairs of those from `begin` to `end` with those behind them. `all` are the boxes by number.
  void add_pairs(std::span<const Aabb> all, std::size_t begin, std::size_t end, PairBuffer& pairs) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  std::size_t axis_ = 0;
  ColumnStore store_;
  std::vector<std::uint32_t> ends_;
};

}  // namespace toccata
