#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad/box_lanes.hpp"
#include "broad/key_sort.hpp"
#include "toccata/broad/broad_phase_cells.hpp"

namespace toccata {

/// How the boxes are put in the order that the tree is made from.
enum class PackingOrder {
  morton,        ///< by the bits of their middles, interleaved
  sort_and_tile  ///< in slabs along one axis, rows along the next, and tiles along the last
};

/// A tree without pointers: the boxes in an order in which neighbours are near each other, and over every sixteen a box
/// around them, level by level.
class PackedTree {
 public:
  /// `boxes` are put in order.
  void build(std::vector<FlatBox>& boxes, PackingOrder order);
  [[nodiscard]] std::size_t size() const { return levels_.empty() ? 0 : levels_.front().size; }

  /// The pairs of boxes in places from `begin` to `end` with those behind them. `all` are the boxes by number.
  void add_pairs(const Aabb* all, std::size_t begin, std::size_t end, PairBuffer& pairs) const;
  /// The pairs of boxes that are not in the tree with those that are.
  void add_pairs_with(const Aabb* all, std::span<const FlatBox> boxes, PairBuffer& pairs) const;

  /// The boxes over every sixteen, a group for each level. `frame` made the floats of those it was built from.
  void add_cells(const FloatFrame& frame, BroadPhaseCells& cells) const;

  /// Makes a box, by the place it had been put in, one that overlaps nothing.
  void forget(std::size_t place);
  /// Gives back the memory that only building needs.
  void drop_scratch();
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Level {
    ColumnStore store;
    std::size_t size = 0;
  };
  /// Where each is to come from is left in `keyed_`.
  void sort_by_curve(std::span<const FlatBox> boxes);
  [[nodiscard]] TreeColumns columns() const;

  std::vector<Level> levels_;
  std::size_t depth_ = 0;  ///< of the levels, those in use
  std::vector<Keyed<std::uint32_t>> keyed_, sorted_;
  std::vector<FlatBox> ordered_;
};

}  // namespace toccata
