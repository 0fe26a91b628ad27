#include "trees/sorted_split.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "trees/split_cost.hpp"

namespace toccata {
namespace {

/// The weights of a few items, which are asked for often.
const std::array<float, most_sorted>& small_weights() {
  static const auto weights = [] {
    std::array<float, most_sorted> table;
    for (std::uint32_t i = 0; i < most_sorted; ++i) table[i] = weight(i);
    return table;
  }();
  return weights;
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

void sort(std::span<FloatItem> items, const FloatBox& middles, int axis) {
  const Order order(items, middles, axis);
  std::array<FloatItem, most_sorted> sorted;
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = items[order[i]];
  std::copy_n(sorted.begin(), order.size(), items.begin());
}

}  // namespace

std::uint32_t sort_for_split(std::span<FloatItem> items, const Part& part) {
  const Float4 size = part.middles.upper - part.middles.lower;
  const int longest = longest_axis(part.middles);
  Place best;
  // The longest axis, and those at least half as long.
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != longest && size[axis] <= 0.5F * size[longest]) continue;
    const Place place = best_place(items, part, Order(items, part.middles, axis));
    if (place.cost < best.cost) best = place;
  }
  sort(items, part.middles, best.axis);
  return best.left_count;
}

}  // namespace toccata
