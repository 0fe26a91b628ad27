#include "query/part_tree.hpp"

#include <algorithm>
#include <numeric>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// Finite numbers for any box.
Vec3 middle_of(const Aabb& box) {
  const auto half = [](double x) { return 0.5 * std::clamp(x, -greatest_double, greatest_double); };
  Vec3 middle;
  for (int axis = 0; axis < 3; ++axis) middle[axis] = half(box.lower[axis]) + half(box.upper[axis]);
  return middle;
}

}  // namespace

void PartTree::start(const std::vector<Aabb>& boxes) {
  nodes_.clear();
  middles_.clear();
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), Index{0});
  if (!boxes.empty()) add(0, static_cast<Index>(boxes.size()), boxes);
}

Index PartTree::children(Index number, const std::vector<Aabb>& boxes) {
  const Node node = nodes_[number];
  if (node.child != 0) return node.child;
  if (middles_.empty())
    for (const Aabb& box : boxes) middles_.push_back(middle_of(box));
  halve(node);
  const Index half = node.first + node.count() / 2, child = static_cast<Index>(nodes_.size());
  nodes_[number].child = child;
  add(node.first, half, boxes);
  add(half, node.last, boxes);
  return child;
}

/// The smaller middles along the axis of their greatest spread first.
void PartTree::halve(const Node& node) {
  const auto begin = order_.begin() + node.first, end = order_.begin() + node.last;
  Vec3 low{infinity, infinity, infinity}, high = -low;
  for (auto at = begin; at != end; ++at)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], middles_[*at][axis]);
      high[axis] = std::max(high[axis], middles_[*at][axis]);
    }
  const Vec3 spread = 0.5 * high - 0.5 * low;
  const int axis = spread.x >= spread.y && spread.x >= spread.z ? 0 : spread.y >= spread.z ? 1 : 2;
  std::nth_element(begin, begin + node.count() / 2, end, [&](Index i, Index j) {
    const double x = middles_[i][axis], y = middles_[j][axis];
    return x < y || (x == y && i < j);
  });
}

void PartTree::add(Index first, Index last, const std::vector<Aabb>& boxes) {
  Node node{{}, first, last};
  for (Index i = first; i < last; ++i) node.box = merge(node.box, boxes[order_[i]]);
  nodes_.push_back(node);
}

}  // namespace toccata
