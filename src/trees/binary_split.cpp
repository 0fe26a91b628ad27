#include "trees/binary_split.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

constexpr std::size_t slab_count = 16;
constexpr std::size_t most_sorted = 64;  ///< so few items are sorted, and all places tried

std::uint32_t blocks_for(std::uint32_t items) { return (items + 7) / 8; }

float cost(const FloatBox& box, std::uint32_t count) { return visit_cost(box) * static_cast<float>(blocks_for(count)); }

int longest_axis(const FloatBox& middles) {
  const Float4 size = middles.upper - middles.lower;
  return size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : (size[1] >= size[2] ? 1 : 2);
}

/// Tells the slab of an item, along the longest axis of the centres.
struct Slabs {
  int axis;
  float origin;
  float scale;

  Slabs(const FloatBox& middles, float count)
      : axis(longest_axis(middles)), origin(middles.lower[axis]), scale(count / (middles.upper[axis] - origin)) {}

  /// Not where all centres coincide, or nearly so.
  [[nodiscard]] bool usable() const { return std::isfinite(scale); }

  [[nodiscard]] std::uint32_t of(const FloatItem& item) const {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>((item.middle(axis) - origin) * scale));
  }
};

/// What lies in one slab.
struct Slab {
  FloatBox box;
  FloatBox middles;
  std::uint32_t count = 0;

  void add(const FloatItem& item) {
    box.add(item);
    middles.add_point(item.middle());
    ++count;
  }
  void add(const Slab& other) {
    box.add(other.box);
    middles.add(other.middles);
    count += other.count;
  }
};

using AllSlabs = std::array<Slab, slab_count>;

/// The first slab of the right side, where the cost is least; of equals the one that splits more evenly.
std::size_t best_border(const AllSlabs& slabs) {
  std::array<float, slab_count> right_cost;
  Slab right;
  for (std::size_t i = slab_count - 1; i > 0; --i) {
    right.box.add(slabs[i].box);
    right.count += slabs[i].count;
    right_cost[i] = cost(right.box, right.count);
  }
  const std::uint32_t all = right.count + slabs[0].count;
  Slab left;
  std::size_t best = 1;
  float best_cost = FloatBox::infinity;
  std::uint32_t best_least_side = 0;
  for (std::size_t i = 1; i < slab_count; ++i) {
    left.box.add(slabs[i - 1].box);
    left.count += slabs[i - 1].count;
    const float both = cost(left.box, left.count) + right_cost[i];
    const std::uint32_t least_side = std::min(left.count, all - left.count);
    if (both > best_cost || (both == best_cost && least_side <= best_least_side)) continue;
    best_cost = both;
    best_least_side = least_side;
    best = i;
  }
  return best;
}

/// Brings the items of the first slabs to the front. Without a branch on the slab, which could not be foreseen.
void partition(std::span<FloatItem> items, const Slabs& slabs, std::size_t border) {
  std::size_t front = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const FloatItem item = items[i];
    items[i] = items[front];
    items[front] = item;
    front += slabs.of(item) < border ? 1 : 0;
  }
}

SplitPart sides(const Part& part, const Slab& left, const Slab& right) {
  return {{left.box, left.middles, part.first, left.count},
          {right.box, right.middles, part.first + left.count, right.count}};
}

/// The slab of the least centre is the first, and that of the greatest the last, so no side is empty.
SplitPart split_by_slabs(std::span<FloatItem> items, const Part& part) {
  // A little less than the number of slabs: the greatest centre then is in the last of them.
  const Slabs slabs(part.middles, static_cast<float>(slab_count) * 0.99999F);
  if (!slabs.usable()) return {};
  const auto own = items.subspan(part.first, part.count);
  AllSlabs all;
  for (const FloatItem& item : own) all[slabs.of(item)].add(item);
  const std::size_t border = best_border(all);
  partition(own, slabs, border);
  Slab left, right;
  for (std::size_t i = 0; i < slab_count; ++i) (i < border ? left : right).add(all[i]);
  return sides(part, left, right);
}

using Int4 [[gnu::vector_size(16)]] = std::int32_t;

/// Keys of a few items that are different from each other, and in the order of their centres.
struct alignas(16) Keys {
  static constexpr std::int32_t slab_count = 1 << 24;
  std::array<std::int32_t, most_sorted> key;

  Keys(std::span<const FloatItem> items, const FloatBox& middles) {
    const Slabs slabs(middles, static_cast<float>(slab_count) * 0.99999F);
    const auto of = [&](std::size_t i) { return slabs.usable() ? static_cast<std::int32_t>(slabs.of(items[i])) : 0; };
    for (std::size_t i = 0; i < items.size(); ++i)
      key[i] = of(i) * static_cast<std::int32_t>(most_sorted) + static_cast<std::int32_t>(i);
    for (std::size_t i = items.size(); i % 4 != 0; ++i) key[i] = std::numeric_limits<std::int32_t>::max();
  }

  /// How many keys are less than the i-th.
  [[nodiscard]] std::size_t rank(std::size_t i, std::size_t count) const {
    const Int4 own{key[i], key[i], key[i], key[i]};
    Int4 less{};
    for (std::size_t j = 0; j < count; j += 4) less -= Int4{key[j], key[j + 1], key[j + 2], key[j + 3]} < own;
    return static_cast<std::size_t>(less[0] + less[1] + less[2] + less[3]);
  }
};

/// Sorts a few items along the longest axis of their centres, without branches that could not be foreseen.
void sort(std::span<FloatItem> items, const FloatBox& middles) {
  const Keys keys(items, middles);
  std::array<FloatItem, most_sorted> sorted;
  for (std::size_t i = 0; i < items.size(); ++i) sorted[keys.rank(i, items.size())] = items[i];
  std::copy_n(sorted.begin(), items.size(), items.begin());
}

/// The number of items of the left side, where the cost of sorted items is least.
std::uint32_t best_place(std::span<const FloatItem> items) {
  const auto count = static_cast<std::uint32_t>(items.size());
  std::array<float, most_sorted> right_cost;
  FloatBox right;
  for (std::uint32_t i = count - 1; i > 0; --i) {
    right.add(items[i]);
    right_cost[i] = cost(right, count - i);
  }
  FloatBox left;
  std::uint32_t best = 1;
  float best_cost = FloatBox::infinity;
  std::uint32_t best_least_side = 0;
  for (std::uint32_t i = 1; i < count; ++i) {
    left.add(items[i - 1]);
    const float both = cost(left, i) + right_cost[i];
    const std::uint32_t least_side = std::min(i, count - i);
    if (both > best_cost || (both == best_cost && least_side <= best_least_side)) continue;
    best_cost = both;
    best_least_side = least_side;
    best = i;
  }
  return best;
}

SplitPart split_at(std::span<const FloatItem> items, const Part& part, std::uint32_t left_count) {
  return {part_of(items, part.first, left_count), part_of(items, part.first + left_count, part.count - left_count)};
}

SplitPart split_sorted(std::span<FloatItem> items, const Part& part) {
  const auto own = items.subspan(part.first, part.count);
  sort(own, part.middles);
  return split_at(items, part, best_place(own));
}

}  // namespace

Part part_of(std::span<const FloatItem> items, std::uint32_t first, std::uint32_t count) {
  Part part{{}, {}, first, count};
  for (const FloatItem& item : items.subspan(first, count)) {
    part.box.add(item);
    part.middles.add_point(item.middle());
  }
  return part;
}

SplitPart split_in_halves(std::span<const FloatItem> items, const Part& part) {
  const std::uint32_t blocks = blocks_for(part.count);
  return split_at(items, part, blocks > 1 ? blocks / 2 * 8 : part.count / 2);
}

SplitPart split(std::span<FloatItem> items, const Part& part) {
  if (part.count <= most_sorted) return split_sorted(items, part);
  const SplitPart by_slabs = split_by_slabs(items, part);
  return by_slabs.left.count > 0 ? by_slabs : split_in_halves(items, part);
}

}  // namespace toccata
