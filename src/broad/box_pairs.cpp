#include "toccata/broad/box_pairs.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "toccata/trees/build.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

std::vector<Index> non_empty(std::span<const Aabb> boxes) {
  std::vector<Index> numbers;
  for (Index i = 0; i < boxes.size(); ++i)
    if (!is_empty(boxes[i])) numbers.push_back(i);
  return numbers;
}

/// Collects the items after one whose boxes overlap a box.
class OverlappingAfter {
 public:
  OverlappingAfter(std::span<const Aabb> boxes, std::span<const Index> number_of_item, Index number)
      : boxes_(boxes), number_of_item_(number_of_item), number_(number) {}
  double bound(const Aabb& node) const {
    return overlap(node, boxes_[number_]) ? 0 : std::numeric_limits<double>::infinity();
  }
  double limit() const { return 0; }
  void visit(std::span<const Index> items) {
    for (const Index item : items) {
      const Index other = number_of_item_[item];
      if (other > number_ && overlap(boxes_[other], boxes_[number_])) found.push_back(other);
    }
  }

  std::vector<Index> found;

 private:
  std::span<const Aabb> boxes_;
  std::span<const Index> number_of_item_;
  Index number_;
};

}  // namespace

BoxIndex::BoxIndex(std::span<const Aabb> boxes)
    : boxes_(boxes.begin(), boxes.end()), number_of_item_(non_empty(boxes)) {
  std::vector<Aabb> items;
  items.reserve(number_of_item_.size());
  for (const Index number : number_of_item_) items.push_back(boxes_[number]);
  tree_ = build_tree(items);
}

std::vector<Index> BoxIndex::overlapping_after(Index number) const {
  if (is_empty(boxes_[number])) return {};
  OverlappingAfter question(boxes_, number_of_item_, number);
  walk(tree_, question);
  std::sort(question.found.begin(), question.found.end());
  return std::move(question.found);
}

std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes) {
  const BoxIndex index(boxes);
  std::vector<IndexPair> pairs;
  for (Index i = 0; i < boxes.size(); ++i)
    for (const Index j : index.overlapping_after(i)) pairs.push_back({i, j});
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
