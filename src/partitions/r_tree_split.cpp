#include "partitions/r_tree_split.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "bounds/point_clouds.hpp"
#include "math/constants.hpp"

namespace toccata {
namespace {

/// Sizes without end differ by what is no number: then nothing is known of which is better.
double or_infinite(double cost) { return std::isnan(cost) ? infinity : cost; }

double sum_of_sides(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  return size.x + size.y + size.z;
}

double shared_area(const Aabb& a, const Aabb& b) {
  Aabb both;
  for (int axis = 0; axis < 3; ++axis) {
    both.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
    both.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
    if (!(both.lower[axis] <= both.upper[axis])) return 0;
  }
  return half_area(both);
}

/// All ways to share the boxes in one order: the boxes around the first i, and around the rest.
class Sharing {
 public:
  Sharing(std::span<const Aabb> boxes, std::vector<Index> order) : order_(std::move(order)) {
    const std::size_t count = order_.size();
    first_.resize(count + 1);
    rest_.resize(count + 1);
    for (std::size_t i = 0; i < count; ++i) first_[i + 1] = merge(first_[i], boxes[order_[i]]);
    for (std::size_t i = count; i > 0; --i) rest_[i - 1] = merge(rest_[i], boxes[order_[i - 1]]);
  }

  [[nodiscard]] double sides(std::size_t least) const {
    double sum = 0;
    for (std::size_t i = least; i + least <= order_.size(); ++i)
      sum += sum_of_sides(first_[i]) + sum_of_sides(rest_[i]);
    return or_infinite(sum);
  }
  /// The overlap, then the areas.
  [[nodiscard]] std::pair<double, double> cost(std::size_t i) const {
    return {or_infinite(shared_area(first_[i], rest_[i])), or_infinite(half_area(first_[i]) + half_area(rest_[i]))};
  }
  [[nodiscard]] const std::vector<Index>& order() const { return order_; }

 private:
  std::vector<Index> order_;
  std::vector<Aabb> first_, rest_;
};

std::array<Sharing, 2> sharings(std::span<const Aabb> boxes, int axis) {
  std::vector<Index> order(boxes.size());
  for (Index i = 0; i < order.size(); ++i) order[i] = i;
  const auto by = [&](auto corner, auto other) {
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      return std::tuple((boxes[a].*corner)[axis], (boxes[a].*other)[axis], a) <
             std::tuple((boxes[b].*corner)[axis], (boxes[b].*other)[axis], b);
    });
    return Sharing(boxes, order);
  };
  return {by(&Aabb::lower, &Aabb::upper), by(&Aabb::upper, &Aabb::lower)};
}

/// The axis along which the middles that are numbers spread the widest.
int widest_axis(std::span<const Aabb> boxes, std::span<const Index> numbers) {
  Aabb middles;
  for (const Index number : numbers)
    if (const Vec3 middle = centre_of(boxes[number]); is_finite(middle)) middles = merge(middles, middle);
  const Vec3 spread = 0.5 * middles.upper - 0.5 * middles.lower;
  if (spread.x >= spread.y) return spread.x >= spread.z ? 0 : 2;
  return spread.y >= spread.z ? 1 : 2;
}

void halve(std::span<const Aabb> boxes, std::span<Index> numbers, std::span<const std::size_t> tiles) {
  if (tiles.size() <= 2) return;
  const std::size_t half = tiles.size() / 2;
  const std::span<Index> mine = numbers.subspan(tiles.front(), tiles.back() - tiles.front());
  const int axis = widest_axis(boxes, mine);
  const auto key = [&](Index number) {
    const double at = centre_of(boxes[number])[axis];
    return std::pair(std::isnan(at) ? infinity : at, number);
  };
  std::nth_element(mine.begin(), mine.begin() + static_cast<std::ptrdiff_t>(tiles[half] - tiles.front()), mine.end(),
                   [&](Index a, Index b) { return key(a) < key(b); });
  halve(boxes, numbers, tiles.first(half + 1));
  halve(boxes, numbers, tiles.subspan(half));
}

}  // namespace

NodeSplit split_of(std::span<const Aabb> boxes, std::size_t least) {
  std::array<Sharing, 2> best = sharings(boxes, 0);
  double least_sides = best[0].sides(least) + best[1].sides(least);
  for (int axis = 1; axis < 3; ++axis) {
    std::array<Sharing, 2> other = sharings(boxes, axis);
    const double sides = other[0].sides(least) + other[1].sides(least);
    if (sides < least_sides) {
      best = std::move(other);
      least_sides = sides;
    }
  }
  NodeSplit split{best[0].order(), least};
  std::pair<double, double> least_cost = best[0].cost(least);
  for (const Sharing& sharing : best)
    for (std::size_t i = least; i + least <= boxes.size(); ++i)
      if (const auto cost = sharing.cost(i); cost < least_cost) {
        split = {sharing.order(), i};
        least_cost = cost;
      }
  return split;
}

void sort_into_tiles(std::span<const Aabb> boxes, std::span<Index> numbers, std::span<const std::size_t> tiles) {
  halve(boxes, numbers, tiles);
}

}  // namespace toccata
