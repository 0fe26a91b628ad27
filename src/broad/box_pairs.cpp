#include "toccata/broad/box_pairs.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace toccata {
namespace {

IndexPair ordered(Index a, Index b) { return a < b ? IndexPair{a, b} : IndexPair{b, a}; }

std::vector<Index> non_empty(std::span<const Aabb> boxes) {
  std::vector<Index> numbers;
  for (Index i = 0; i < boxes.size(); ++i)
    if (!is_empty(boxes[i])) numbers.push_back(i);
  return numbers;
}

/// The variance of the lower corners. It may overflow; then the choice of the axis is worse, never the answer.
double spread(std::span<const Aabb> boxes, std::span<const Index> numbers, int axis) {
  const double count = static_cast<double>(numbers.size());
  double mean = 0;
  for (const Index i : numbers) mean += boxes[i].lower[axis] / count;
  double sum = 0;
  for (const Index i : numbers) sum += (boxes[i].lower[axis] - mean) * (boxes[i].lower[axis] - mean);
  return sum;
}

int axis_of_largest_spread(std::span<const Aabb> boxes, std::span<const Index> numbers) {
  const std::array<double, 3> spreads{spread(boxes, numbers, 0), spread(boxes, numbers, 1), spread(boxes, numbers, 2)};
  return static_cast<int>(std::max_element(spreads.begin(), spreads.end()) - spreads.begin());
}

}  // namespace

std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes) {
  std::vector<Index> numbers = non_empty(boxes);
  const int axis = axis_of_largest_spread(boxes, numbers);
  const auto key = [&](Index i) { return std::pair(boxes[i].lower[axis], i); };
  std::sort(numbers.begin(), numbers.end(), [&](Index i, Index j) { return key(i) < key(j); });

  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Aabb& box = boxes[numbers[i]];
    // Touching counts, so a box that starts where this one ends is still looked at.
    for (std::size_t j = i + 1; j < numbers.size() && boxes[numbers[j]].lower[axis] <= box.upper[axis]; ++j)
      if (overlap(box, boxes[numbers[j]])) pairs.push_back(ordered(numbers[i], numbers[j]));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<IndexPair> overlapping_pairs_by_brute_force(std::span<const Aabb> boxes) {
  const std::vector<Index> numbers = non_empty(boxes);
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = i + 1; j < numbers.size(); ++j)
      if (overlap(boxes[numbers[i]], boxes[numbers[j]])) pairs.push_back({numbers[i], numbers[j]});
  return pairs;
}

}  // namespace toccata
