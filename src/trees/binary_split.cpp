#include "trees/binary_split.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "trees/sorted_split.hpp"
#include "trees/split_cost.hpp"

namespace toccata {
namespace {

constexpr std::size_t slab_count = 16;

/// What lies in one slab.
struct Slab {
  FloatBox box = FloatBox::empty();
  FloatBox middles = FloatBox::empty();
  std::uint32_t items = 0;

  template <typename Record>
  void add(const Record& record) {
    box.add(record);
    middles.add_point(record.middle());
    items += item_count(record);
  }
  void merge(const Slab& other) {
    box.add(other.box);
    middles.add(other.middles);
    items += other.items;
  }
};

using AllSlabs = std::array<Slab, slab_count>;

/// The first slab of the right side, where the sides' numbers of items are most alike.
std::size_t most_even_border(const AllSlabs& slabs, std::uint32_t items) {
  std::size_t best = 1;
  std::uint32_t left = 0, best_least_side = 0;
  for (std::size_t i = 1; i < slab_count; ++i) {
    left += slabs[i - 1].items;
    const std::uint32_t least_side = std::min(left, items - left);
    if (least_side <= best_least_side) continue;
    best_least_side = least_side;
    best = i;
  }
  return best;
}

/// The first slab of the right side, where the cost is least; the first of equals.
std::size_t best_border(const AllSlabs& slabs, const Part& part) {
  std::array<float, slab_count> right_costs;
  FloatBox right = FloatBox::empty();
  for (std::size_t i = slab_count - 1; i > 0; --i) {
    right.add(slabs[i].box);
    right_costs[i] = visit_cost(right);
  }
  FloatBox left = FloatBox::empty();
  std::uint32_t left_items = 0;
  std::size_t best = 1;
  float best_cost = FloatBox::infinity;
  bool best_hardly_pays = false;
  for (std::size_t i = 1; i < slab_count; ++i) {
    left.add(slabs[i - 1].box);
    left_items += slabs[i - 1].items;
    const float left_cost = visit_cost(left);
    const float both = left_cost * weight(left_items) + right_costs[i] * weight(part.items - left_items);
    if (both >= best_cost) continue;
    best_cost = both;
    best_hardly_pays = hardly_pays(left_cost, right_costs[i], part.box);
    best = i;
  }
  return best_hardly_pays ? most_even_border(slabs, part.items) : best;
}

/// Brings the items or cells of the first slabs to the front, and returns how many these are. Without a branch on the
/// slab, which could not be foreseen.
template <typename Record>
std::uint32_t partition(std::span<Record> records, const Slabs& slabs, std::size_t border) {
  std::uint32_t front = 0;
  for (Record& next : records) {
    const Record record = next;
    next = records[front];
    records[front] = record;
    front += slabs.of(record) < border ? 1 : 0;
  }
  return front;
}

/// No left side when the centres coincide. Otherwise the slab of the least centre is the first, and that of the
/// greatest the last, so no side is empty.
template <typename Record>
SplitPart split_by_slabs(std::span<Record> records, const Part& part) {
  const Slabs slabs(part.middles, longest_axis(part.middles), slab_count);
  if (!slabs.usable()) return {};
  const auto own = records.subspan(part.first, part.count);
  AllSlabs all;
  for (const Record& record : own) all[slabs.of(record)].add(record);
  const std::size_t border = best_border(all, part);
  const std::uint32_t left_count = partition(own, slabs, border);
  Slab left, right;
  for (std::size_t i = 0; i < slab_count; ++i) (i < border ? left : right).merge(all[i]);
  return {{left.box, left.middles, part.first, left_count, left.items},
          {right.box, right.middles, part.first + left_count, part.count - left_count, right.items}};
}

template <typename Record>
Part part_of_run(std::span<const Record> records, std::uint32_t first, std::uint32_t count) {
  Slab all;
  for (const Record& record : records.subspan(first, count)) all.add(record);
  return {all.box, all.middles, first, count, all.items};
}

template <typename Record>
SplitPart split_at(std::span<const Record> records, const Part& part, std::uint32_t left_count) {
  return {part_of_run(records, part.first, left_count),
          part_of_run(records, part.first + left_count, part.count - left_count)};
}

}  // namespace

Part part_of(std::span<const FloatItem> items, std::uint32_t first, std::uint32_t count) {
  return part_of_run(items, first, count);
}

Part part_of(std::span<const Cell> cells, std::uint32_t first, std::uint32_t count) {
  return part_of_run(cells, first, count);
}

SplitPart split_in_halves(std::span<const FloatItem> items, const Part& part) {
  return split_at(items, part, half_of(part.count));
}

SplitPart split_in_halves(std::span<const Cell> cells, const Part& part) {
  return split_at(cells, part, half_of(part.count));
}

SplitPart split(std::span<FloatItem> items, const Part& part) {
  if (part.count <= most_sorted) {
    const std::uint32_t left_count = sort_for_split(items.subspan(part.first, part.count), part);
    return split_at<FloatItem>(items, part, left_count);
  }
  const SplitPart by_slabs = split_by_slabs(items, part);
  return by_slabs.left.count > 0 ? by_slabs : split_in_halves(items, part);
}

SplitPart split(std::span<Cell> cells, const Part& part) {
  const SplitPart by_slabs = split_by_slabs(cells, part);
  return by_slabs.left.count > 0 ? by_slabs : split_in_halves(cells, part);
}

}  // namespace toccata
