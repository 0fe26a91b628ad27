#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broad/box_lanes.hpp"
#include "broad/key_sort.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata {

/// How the boxes are put in the order that the tree is made from.
enum class PackingOrder {
  morton,        ///< by the bits of their middles, interleaved
  sort_and_tile  ///< in slabs along one axis, rows along the next, and tiles along the last
};

/// Where its middle lies along Morton's curve, with 21 bits for each axis. `box` is of a frame, in which most lie
/// within 2 of the middle; others count as at the rim.
[[nodiscard]] std::uint64_t curve_key(const FlatBox& box);

/// Boxes of one frame in the order of the curve.
void sort_along_curve(std::vector<FlatBox>& boxes);

/// A tree without pointers: the boxes in an order in which neighbours are near each other, and over every sixteen a box
/// around them, level by level.
class PackedBvh {
 public:
  void build(std::span<const FlatBox> boxes, PackingOrder order);
  /// In the order of the curve, of those of `boxes` that are not empty and for whose numbers `is_in` says so. Each is
  /// made flat twice, and nowhere kept besides.
  template <class IsIn>
  void build(const FloatFrame& frame, std::span<const Aabb> boxes, const IsIn& is_in) {
    keyed_.clear();
    keyed_.reserve(boxes.size());
    const auto box_at = [&](std::uint32_t number) { return flat_box(frame, boxes[number], number); };
    for (std::uint32_t number = 0; number < boxes.size(); ++number)
      if (!is_empty(boxes[number]) && is_in(number)) keyed_.push_back({first_key(box_at(number)), number});
    sort_by_curve(box_at);
    lay_out(box_at, [&](std::uint32_t number) {
      __builtin_prefetch(&boxes[number]);
      __builtin_prefetch(&boxes[number].upper.z);
    });
  }
  [[nodiscard]] std::size_t size() const { return levels_.empty() ? 0 : levels_.front().size; }
  /// The number of the box that was put in this place.
  [[nodiscard]] Index number(std::size_t place) const { return levels_.front().store.number(place); }

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
  using Key = Keyed<std::uint32_t>;

  /// The upper bits of the place along the curve.
  [[nodiscard]] static std::uint32_t first_key(const FlatBox& box) {
    return static_cast<std::uint32_t>(curve_key(box) >> 31);
  }
  /// The boxes of `keyed_`, whose first keys are there.
  template <class BoxAt>
  void sort_by_curve(const BoxAt& box_at) {
    sort_by_key(keyed_, sorted_);
    // The lower bits matter only where boxes lie close together in a wide world.
    std::vector<Keyed<std::uint64_t>> equal;
    for (std::size_t first = 0, last; first < keyed_.size(); first = last) {
      for (last = first + 1; last < keyed_.size() && keyed_[last].key == keyed_[first].key; ++last) {
      }
      if (last - first <= BvhColumns::width) continue;
      equal.clear();
      for (std::size_t i = first; i < last; ++i) equal.push_back({curve_key(box_at(keyed_[i].place)), keyed_[i].place});
      sort_equal(equal);
      for (std::size_t i = first; i < last; ++i) keyed_[i].place = equal[i - first].place;
    }
  }
  static void sort_equal(std::vector<Keyed<std::uint64_t>>& equal);

  /// The boxes in the order of `keyed_`, and all levels over them.
  template <class BoxAt, class Fetch>
  void lay_out(const BoxAt& box_at, const Fetch& fetch) {
    constexpr std::size_t ahead = 16;
    Level& items = first_level(keyed_.size());
    for (std::size_t i = 0; i < keyed_.size(); ++i) {
      // They lie anywhere.
      if (i + ahead < keyed_.size()) fetch(keyed_[i + ahead].place);
      items.store.put(i, box_at(keyed_[i].place));
    }
    build_levels();
  }
  Level& first_level(std::size_t size);
  void build_levels();
  [[nodiscard]] BvhColumns columns() const;

  std::vector<Level> levels_;
  std::size_t depth_ = 0;  ///< of the levels, those in use
  std::vector<Key> keyed_, sorted_;
};

}  // namespace toccata
