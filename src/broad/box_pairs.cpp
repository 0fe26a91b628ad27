#include "toccata/broad/broad_phase.hpp"

namespace toccata {
namespace {

std::vector<Index> non_empty(std::span<const Aabb> boxes) {
  std::vector<Index> numbers;
  for (Index i = 0; i < boxes.size(); ++i)
    if (!is_empty(boxes[i])) numbers.push_back(i);
  return numbers;
}

}  // namespace

std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes) {
  return overlapping_pairs(boxes, BroadPhaseOptions{});
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
