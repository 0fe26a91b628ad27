#include "toccata/partitions/kd_tree.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "math/constants.hpp"
#include "partitions/region_tree.hpp"

namespace toccata {
namespace {

constexpr int intervals = 32;

/// Half the area of its sides over that of the whole, which has sides above 0 along at least two axes; by halves, which
/// do not overflow, and relative to its longest side.
double relative_area(const Aabb& part, const Aabb& whole) {
  const Vec3 size = 0.5 * whole.upper - 0.5 * whole.lower;
  const double longest = std::max({size.x, size.y, size.z});
  const auto area = [&](const Aabb& box) {
    Vec3 side = 0.5 * box.upper - 0.5 * box.lower;
    for (int axis = 0; axis < 3; ++axis) side[axis] /= longest;
    return side.x * side.y + side.y * side.z + side.z * side.x;
  };
  const double all = area(whole);
  return all > 0 ? area(part) / all : 0.5;
}

struct AxisCut {
  int axis = 0;
  double at = 0;
  double cost = infinity;
};

std::pair<Aabb, Aabb> halves(const Aabb& box, int axis, double at) {
  std::pair<Aabb, Aabb> parts(box, box);
  parts.first.upper[axis] = at;
  parts.second.lower[axis] = at;
  return parts;
}

/// Along one axis: how many items begin and how many end in each interval between two planes.
class Cuts {
 public:
  Cuts(const Aabb& box, int axis, std::span<const Index> items, std::span<const Aabb> boxes) : box_(box), axis_(axis) {
    for (const Index item : items) {
      ++begins_[interval_of(boxes[item].lower[axis])];
      ++ends_[interval_of(boxes[item].upper[axis])];
    }
    count_ = items.size();
  }

  [[nodiscard]] AxisCut best() const {
    AxisCut best;
    std::size_t below = 0, not_above = 0;
    for (std::size_t i = 1; i < intervals; ++i) {
      below += begins_[i - 1];
      not_above += ends_[i - 1];
      const double at = plane(i);
      if (!(box_.lower[axis_] < at && at < box_.upper[axis_])) continue;
      const auto [low, high] = halves(box_, axis_, at);
      const double cost = 1 + relative_area(low, box_) * static_cast<double>(below) +
                          relative_area(high, box_) * static_cast<double>(count_ - not_above);
      if (cost < best.cost) best = {axis_, at, cost};
    }
    return best;
  }

 private:
  [[nodiscard]] double plane(std::size_t i) const {
    const double part = static_cast<double>(i) / intervals;
    return box_.lower[axis_] * (1 - part) + box_.upper[axis_] * part;
  }
  /// Those on a plane may be counted on either side of it: costs need not be exact.
  [[nodiscard]] std::size_t interval_of(double at) const {
    const double size = 0.5 * box_.upper[axis_] - 0.5 * box_.lower[axis_];
    const double part = size > 0 ? (0.5 * at - 0.5 * box_.lower[axis_]) / size * intervals : 0;
    return static_cast<std::size_t>(std::clamp(part, 0.0, intervals - 1.0));
  }

  Aabb box_;
  int axis_;
  std::size_t count_ = 0;
  std::array<std::size_t, intervals> begins_{}, ends_{};
};

std::vector<Aabb> cut_by_area(const Aabb& box, std::span<const Index> items, std::span<const Aabb> boxes) {
  AxisCut best;
  for (int axis = 0; axis < 3; ++axis)
    if (const AxisCut cut = Cuts(box, axis, items, boxes).best(); cut.cost < best.cost) best = cut;
  if (!(best.cost < static_cast<double>(items.size()))) return {};
  const auto [low, high] = halves(box, best.axis, best.at);
  return {low, high};
}

}  // namespace

class KdTree::State {
 public:
  State(PartitionItems held, const KdTreeOptions& options)
      : items(std::move(held)),
        tree(build_regions(
            items, items.bounds(), {options.leaf_items, options.most_depth, options.most_copies, RegionCuts::may_trim},
            [&](const Aabb& box, std::span<const Index> in_it) { return cut_by_area(box, in_it, items.boxes()); })) {}
  PartitionItems items;
  RegionTree tree;
};

KdTree::KdTree(const PartitionItems& items, const KdTreeOptions& options)
    : state_(std::make_unique<State>(items, options)) {}
KdTree::KdTree(KdTree&&) noexcept = default;
KdTree& KdTree::operator=(KdTree&&) noexcept = default;
KdTree::~KdTree() = default;

std::vector<Index> KdTree::candidates(const Aabb& box) const { return state_->tree.candidates(state_->items, box); }
std::vector<IndexPair> KdTree::candidate_pairs() const { return state_->tree.candidate_pairs(state_->items); }
std::vector<PartitionCell> KdTree::cells() const { return state_->tree.cells(); }
std::vector<PartitionCell> KdTree::cells_at(Index depth) const { return state_->tree.cells_at(depth); }
Index KdTree::greatest_depth() const { return state_->tree.greatest_depth(); }
std::size_t KdTree::bytes() const { return state_->tree.bytes(); }

}  // namespace toccata
