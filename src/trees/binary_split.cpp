#include "trees/binary_split.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

constexpr std::size_t slab_count = 16;
constexpr std::size_t most_sorted = 32;  ///< so few items are sorted, and all places tried

std::uint32_t blocks_for(std::uint32_t items) { return (items + 7) / 8; }

/// What looking into a part costs, for each time that its box is met. Rather than the number of its items (or of its
/// blocks, which is what makes full blocks cheap) it is the square root: the boxes of surfaces get smaller as there are
/// more of them. Measured over the powers from 0.35 to 1 on scanned and designed meshes.
float weight(std::uint32_t items) { return std::sqrt(static_cast<float>(8 * blocks_for(items) + items)); }

/// The weights of a few items, which are asked for often.
const std::array<float, most_sorted>& small_weights() {
  static const auto weights = [] {
    std::array<float, most_sorted> table;
    for (std::uint32_t i = 0; i < most_sorted; ++i) table[i] = weight(i);
    return table;
  }();
  return weights;
}

int longest_axis(const FloatBox& middles) {
  const Float4 size = middles.upper - middles.lower;
  return size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : (size[1] >= size[2] ? 1 : 2);
}

/// Tells the slab of an item, along an axis.
struct Slabs {
  int axis;
  float origin;
  float scale;

  // A little less than the number of slabs: the greatest centre then is in the last of them.
  Slabs(const FloatBox& middles, int along, std::size_t count)
      : axis(along),
        origin(middles.lower[axis]),
        scale(0.99999F * static_cast<float>(count) / (middles.upper[axis] - origin)) {}

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

/// Whether the boxes of two sides are so large that splitting hardly pays. The heuristic then means nothing, and would
/// take items off one by one.
bool hardly_pays(float cost_of_left_box, float cost_of_right_box, const FloatBox& whole) {
  return cost_of_left_box + cost_of_right_box > 1.8F * visit_cost(whole);
}

/// The first slab of the right side, where the sides' numbers of items are most alike.
std::size_t most_even_border(const AllSlabs& slabs, std::uint32_t count) {
  std::size_t best = 1;
  std::uint32_t left = 0, best_least_side = 0;
  for (std::size_t i = 1; i < slab_count; ++i) {
    left += slabs[i - 1].count;
    const std::uint32_t least_side = std::min(left, count - left);
    if (least_side <= best_least_side) continue;
    best_least_side = least_side;
    best = i;
  }
  return best;
}

/// The first slab of the right side, where the cost is least; the first of equals.
std::size_t best_border(const AllSlabs& slabs, const Part& part) {
  std::array<float, slab_count> right_costs;
  FloatBox right;
  for (std::size_t i = slab_count - 1; i > 0; --i) {
    right.add(slabs[i].box);
    right_costs[i] = visit_cost(right);
  }
  FloatBox left;
  std::uint32_t left_count = 0;
  std::size_t best = 1;
  float best_cost = FloatBox::infinity;
  bool best_hardly_pays = false;
  for (std::size_t i = 1; i < slab_count; ++i) {
    left.add(slabs[i - 1].box);
    left_count += slabs[i - 1].count;
    const float left_cost = visit_cost(left);
    const float both = left_cost * weight(left_count) + right_costs[i] * weight(part.count - left_count);
    if (both >= best_cost) continue;
    best_cost = both;
    best_hardly_pays = hardly_pays(left_cost, right_costs[i], part.box);
    best = i;
  }
  return best_hardly_pays ? most_even_border(slabs, part.count) : best;
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
  const Slabs slabs(part.middles, longest_axis(part.middles), slab_count);
  if (!slabs.usable()) return {};
  const auto own = items.subspan(part.first, part.count);
  AllSlabs all;
  for (const FloatItem& item : own) all[slabs.of(item)].add(item);
  const std::size_t border = best_border(all, part);
  partition(own, slabs, border);
  Slab left, right;
  for (std::size_t i = 0; i < slab_count; ++i) (i < border ? left : right).add(all[i]);
  return sides(part, left, right);
}

using Int4 [[gnu::vector_size(16)]] = std::int32_t;

/// The order of a few items along an axis of their centres, found without branches that could not be foreseen.
class Order {
 public:
  Order(std::span<const FloatItem> items, const FloatBox& middles, int axis) : count_(items.size()), axis_(axis) {
    set_keys(items, Slabs(middles, axis, key_count));
    for (std::size_t i = 0; i < count_; ++i) places_[rank(keys_[i])] = static_cast<std::uint8_t>(i);
  }

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] int axis() const { return axis_; }

  /// Which item is the i-th.
  [[nodiscard]] std::size_t operator[](std::size_t i) const { return places_[i]; }

 private:
  static constexpr std::size_t key_count = std::size_t{1} << 24;

  /// Keys that are different from each other, and in the order of the centres.
  void set_keys(std::span<const FloatItem> items, const Slabs& slabs) {
    const bool usable = slabs.usable();
    for (std::uint32_t i = 0; i < count_; ++i) {
      const std::uint32_t slab = usable ? slabs.of(items[i]) : 0;
      keys_[i] = static_cast<std::int32_t>(slab * most_sorted + i);
    }
    for (std::size_t i = count_; i % 4 != 0; ++i) keys_[i] = std::numeric_limits<std::int32_t>::max();
  }

  /// How many keys are less.
  [[nodiscard]] std::size_t rank(std::int32_t key) const {
    const Int4 own{key, key, key, key};
    Int4 less{};
    for (std::size_t j = 0; j < count_; j += 4) {
      const Int4 others{keys_[j], keys_[j + 1], keys_[j + 2], keys_[j + 3]};
      less -= others < own;
    }
    return static_cast<std::size_t>(less[0] + less[1] + less[2] + less[3]);
  }

  std::size_t count_;
  int axis_;
  alignas(16) std::array<std::int32_t, most_sorted> keys_;
  std::array<std::uint8_t, most_sorted> places_;
};

/// A way to split a few items: the first of them, along an axis, are the left side.
struct Place {
  float cost = FloatBox::infinity;
  std::uint32_t left_count = 1;
  int axis = 0;
};

/// As many whole blocks of items left as right, or as many items when there is one block only.
std::uint32_t half_of(std::uint32_t count) {
  const std::uint32_t blocks = blocks_for(count);
  return blocks > 1 ? blocks / 2 * 8 : count / 2;
}

/// Where the cost is least along an axis; the first of equals.
Place best_place(std::span<const FloatItem> items, const Part& part, const Order& order) {
  const auto& weights = small_weights();
  std::array<float, most_sorted> right_costs;
  FloatBox right;
  for (std::uint32_t i = part.count - 1; i > 0; --i) {
    right.add(items[order[i]]);
    right_costs[i] = visit_cost(right);
  }
  FloatBox left;
  Place best;
  bool best_hardly_pays = false;
  for (std::uint32_t i = 1; i < part.count; ++i) {
    left.add(items[order[i - 1]]);
    const float left_cost = visit_cost(left);
    const float both = left_cost * weights[i] + right_costs[i] * weights[part.count - i];
    if (both >= best.cost) continue;
    best_hardly_pays = hardly_pays(left_cost, right_costs[i], part.box);
    best = {both, i, order.axis()};
  }
  if (best_hardly_pays) best.left_count = half_of(part.count);
  return best;
}

SplitPart split_at(std::span<const FloatItem> items, const Part& part, std::uint32_t left_count) {
  return {part_of(items, part.first, left_count), part_of(items, part.first + left_count, part.count - left_count)};
}

void sort(std::span<FloatItem> items, const FloatBox& middles, int axis) {
  const Order order(items, middles, axis);
  std::array<FloatItem, most_sorted> sorted;
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = items[order[i]];
  std::copy_n(sorted.begin(), order.size(), items.begin());
}

/// Tries the longest axis, and those at least half as long.
SplitPart split_sorted(std::span<FloatItem> items, const Part& part) {
  const auto own = items.subspan(part.first, part.count);
  const Float4 size = part.middles.upper - part.middles.lower;
  const int longest = longest_axis(part.middles);
  Place best;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != longest && size[axis] <= 0.5F * size[longest]) continue;
    const Place place = best_place(own, part, Order(own, part.middles, axis));
    if (place.cost < best.cost) best = place;
  }
  sort(own, part.middles, best.axis);
  return split_at(items, part, best.left_count);
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
  return split_at(items, part, half_of(part.count));
}

SplitPart split(std::span<FloatItem> items, const Part& part) {
  if (part.count <= most_sorted) return split_sorted(items, part);
  const SplitPart by_slabs = split_by_slabs(items, part);
  return by_slabs.left.count > 0 ? by_slabs : split_in_halves(items, part);
}

}  // namespace toccata
