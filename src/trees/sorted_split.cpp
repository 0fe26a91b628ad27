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

/// Keys of a few items that are different from each other, and in the order of their centres along an axis.
class Keys {
 public:
  Keys(std::span<const FloatItem> items, const FloatBox& middles, int axis) : count_(items.size()) {
    const Slabs slabs(middles, axis, key_count);
    const bool usable = slabs.usable();
    for (std::uint32_t i = 0; i < count_; ++i) {
      const std::uint32_t slab = usable ? slabs.of(items[i]) : 0;
      keys_[i] = static_cast<std::int32_t>(slab * most_sorted + i);
    }
    for (std::size_t i = count_; i % 4 != 0; ++i) keys_[i] = std::numeric_limits<std::int32_t>::max();
  }

  /// How many keys are less than the i-th.
  [[nodiscard]] std::uint32_t rank(std::size_t i) const {
    const Int4 own{keys_[i], keys_[i], keys_[i], keys_[i]};
    Int4 less{};
    for (std::size_t j = 0; j < count_; j += 4) {
      const Int4 others{keys_[j], keys_[j + 1], keys_[j + 2], keys_[j + 3]};
      less -= others < own;
    }
    return static_cast<std::uint32_t>(less[0] + less[1] + less[2] + less[3]);
  }

 private:
  static constexpr std::size_t key_count = std::size_t{1} << 24;

  std::size_t count_;
  alignas(16) std::array<std::int32_t, most_sorted> keys_;
};

/// Which of a few items is the first, the second … along an axis.
using Order = std::array<std::uint8_t, most_sorted>;

/// Found without branches that could not be foreseen.
Order order_along(int axis, std::span<const FloatItem> items, const FloatBox& middles) {
  const Keys keys(items, middles, axis);
  Order order;
  for (std::size_t i = 0; i < items.size(); ++i) order[keys.rank(i)] = static_cast<std::uint8_t>(i);
  return order;
}

/// A way to split a few items: the first of them, in an order, are the left side.
struct Place {
  float cost = FloatBox::infinity;
  std::uint32_t left_count = 1;
};

/// Where the cost is least along an axis; the first of equals.
Place best_place(std::span<const FloatItem> items, const Part& part, const Order& order) {
  const auto& weights = small_weights();
  std::array<float, most_sorted> right_costs;
  FloatBox right = FloatBox::empty();
  for (std::uint32_t i = part.count - 1; i > 0; --i) {
    right.add(items[order[i]]);
    right_costs[i] = visit_cost(right);
  }
  FloatBox left = FloatBox::empty();
  Place best;
  bool best_hardly_pays = false;
  for (std::uint32_t i = 1; i < part.count; ++i) {
    left.add(items[order[i - 1]]);
    const float left_cost = visit_cost(left);
    const float both = left_cost * weights[i] + right_costs[i] * weights[part.count - i];
    if (both >= best.cost) continue;
    best_hardly_pays = hardly_pays(left_cost, right_costs[i], part.box);
    best = {both, i};
  }
  if (best_hardly_pays) best.left_count = half_of(part.count);
  return best;
}

void reorder(std::span<FloatItem> items, const Order& order) {
  std::array<FloatItem, most_sorted> copy;
  std::copy(items.begin(), items.end(), copy.begin());
  for (std::size_t i = 0; i < items.size(); ++i) items[i] = copy[order[i]];
}

}  // namespace

std::uint32_t sort_for_split(std::span<FloatItem> items, const Part& part) {
  const Float4 size = part.middles.upper - part.middles.lower;
  const int longest = longest_axis(part.middles);
  Place best;
  Order best_order;
  // The longest axis, and those at least half as long.
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != longest && size[axis] <= 0.5F * size[longest]) continue;
    const Order order = order_along(axis, items, part.middles);
    const Place place = best_place(items, part, order);
    if (place.cost >= best.cost) continue;
    best = place;
    best_order = order;
  }
  reorder(items, best_order);
  return best.left_count;
}

}  // namespace toccata
