#include "bounds/point_clouds.hpp"
#include "toccata/trees/builders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "math/constants.hpp"

namespace toccata {
namespace {

constexpr std::size_t greatest_bin_count = 16;

// Most nodes are small; more slabs than items would only cost time.
std::size_t bin_count_for(std::size_t items) { return std::clamp<std::size_t>(items / 2, 4, greatest_bin_count); }

// Below this depth nodes are halved instead: boxes spread over many orders of magnitude cannot make the tree a list.
constexpr int greatest_heuristic_depth = 64;

struct Item {
  Aabb box;
  Index number;
};

/// What is known of some items together: what their node needs, and where to split them.
struct Extent {
  Aabb box;
  Aabb centres;
  std::size_t count = 0;

  void add(const Aabb& item) {
    box = merge(box, item);
    centres = merge(centres, centre_of(item));
    ++count;
  }
  void add(const Extent& other) {
    box = merge(box, other.box);
    centres = merge(centres, other.centres);
    count += other.count;
  }
};

Extent extent_of(std::span<const Item> items) {
  Extent extent;
  for (const Item& item : items) extent.add(item.box);
  return extent;
}

/// A node that is to be split: its items, and their extent.
struct SplitTask {
  Index node;
  int depth;
  std::size_t first;
  Extent extent;
};

/// Where a node is split: the items of the left child come first.
struct Split {
  Extent left;
  Extent right;
};

/// Tells the slab of a centre.
class CentreSlabs {
 public:
  CentreSlabs(const Aabb& centres, std::size_t count) : count_(count) {
    const Vec3 size = centres.upper - centres.lower;
    axis_ = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    origin_ = centres.lower[axis_];
    scale_ = static_cast<double>(count) / size[axis_];
  }

  /// Not where all centres coincide, or lie too near or too far apart for the arithmetic.
  [[nodiscard]] bool usable() const { return std::isfinite(scale_) && scale_ > 0; }

  [[nodiscard]] std::size_t count() const { return count_; }

  [[nodiscard]] std::size_t of(const Vec3& centre) const {
    return std::min(static_cast<std::size_t>((centre[axis_] - origin_) * scale_), count_ - 1);
  }

 private:
  std::size_t count_;
  int axis_ = 0;
  double origin_ = 0;
  double scale_ = 0;
};

/// What a split would cost; of equal ones the more even is better, as where boxes on a line all have area 0.
struct SplitCost {
  double area = infinity;
  std::size_t larger_side = 0;
  friend constexpr auto operator<=>(const SplitCost&, const SplitCost&) = default;
};

double area_cost(const Extent& side) { return half_area(side.box) * static_cast<double>(side.count); }

/// The first bin of the right side, where the cost is least; the first of equals.
std::size_t best_border(std::span<const Extent> bins) {
  std::array<SplitCost, greatest_bin_count> right_cost;
  Extent right;
  for (std::size_t i = bins.size() - 1; i > 0; --i) {
    right.add(bins[i]);
    right_cost[i] = {area_cost(right), right.count};
  }
  Extent left;
  std::size_t best = 1;
  SplitCost best_cost;
  for (std::size_t i = 1; i < bins.size(); ++i) {
    left.add(bins[i - 1]);
    const SplitCost both{area_cost(left) + right_cost[i].area, std::max(left.count, right_cost[i].larger_side)};
    if (!(both < best_cost)) continue;
    best_cost = both;
    best = i;
  }
  return best;
}

/// The slab of the least centre is the first, and that of the greatest the last, so no side is empty.
Split split_by_heuristic(std::span<Item> items, const CentreSlabs& slabs) {
  std::array<Extent, greatest_bin_count> all_bins;
  const auto bins = std::span(all_bins).first(slabs.count());
  for (const Item& item : items) bins[slabs.of(centre_of(item.box))].add(item.box);
  const std::size_t border = best_border(bins);
  std::partition(items.begin(), items.end(), [&](const Item& item) { return slabs.of(centre_of(item.box)) < border; });
  Split split;
  for (std::size_t i = 0; i < bins.size(); ++i) (i < border ? split.left : split.right).add(bins[i]);
  return split;
}

Split split_in_halves(std::span<const Item> items) {
  const std::size_t half = items.size() / 2;
  return {extent_of(items.first(half)), extent_of(items.subspan(half))};
}

class Builder {
 public:
  Builder(std::span<const Aabb> boxes, Index leaf_size) : leaf_size_(std::max<Index>(leaf_size, 1)) {
    items_.reserve(boxes.size());
    for (const Aabb& box : boxes) items_.push_back({box, static_cast<Index>(items_.size())});
  }

  Bvh<Aabb> build() {
    if (items_.empty()) return {};
    tree_.nodes.reserve(items_.size());
    add_node(0, extent_of(items_), 0);
    while (!tasks_.empty()) {
      const SplitTask task = tasks_.back();
      tasks_.pop_back();
      expand(task);
    }
    tree_.items.reserve(items_.size());
    for (const Item& item : items_) tree_.items.push_back(item.number);
    return std::move(tree_);
  }

 private:
  /// Adds the node of a run of items, and the task to split it when it is no leaf.
  void add_node(std::size_t first, const Extent& extent, int depth) {
    const Index number = static_cast<Index>(tree_.nodes.size());
    const bool leaf = extent.count <= leaf_size_;
    tree_.nodes.push_back({extent.box, static_cast<Index>(first), leaf ? static_cast<Index>(extent.count) : 0, 0});
    if (!leaf) tasks_.push_back({number, depth, first, extent});
  }

  void expand(const SplitTask& task) {
    const auto items = std::span(items_).subspan(task.first, task.extent.count);
    const CentreSlabs slabs(task.extent.centres, bin_count_for(task.extent.count));
    const bool by_heuristic = slabs.usable() && task.depth < greatest_heuristic_depth;
    const Split split = by_heuristic ? split_by_heuristic(items, slabs) : split_in_halves(items);
    BvhNode<Aabb>& node = tree_.nodes[task.node];
    node.first = static_cast<Index>(tree_.nodes.size());
    node.child_count = 2;
    add_node(task.first, split.left, task.depth + 1);
    add_node(task.first + split.left.count, split.right, task.depth + 1);
  }

  Index leaf_size_;
  std::vector<Item> items_;
  std::vector<SplitTask> tasks_;
  Bvh<Aabb> tree_;
};

}  // namespace

Bvh<Aabb> build_bvh(std::span<const Aabb> boxes, const BuildOptions& options) {
  return Builder(boxes, options.leaf_size).build();
}

}  // namespace toccata
