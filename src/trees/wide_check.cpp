#include "trees/wide_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "math/constants.hpp"
#include "toccata/core/function_ref.hpp"
#include "trees/box_runs.hpp"
#include "trees/wide_frame.hpp"

namespace toccata {
namespace {

/// A real number as a double and what that rounded away.
struct Real2 {
  double rounded = infinity;
  double rest = 0;

  // Equal numbers may compare either way where they lie half way between two doubles.
  friend bool operator<=(const Real2& x, const Real2& y) {
    return x.rounded < y.rounded || (x.rounded == y.rounded && x.rest <= y.rest);
  }
};

/// a + b, times a power of two that keeps it in range.
Real2 sum(double a, double b, double factor) {
  // D. Knuth, "The Art of Computer Programming", volume 2, 4.2.2, Theorem B.
  const double rounded = a + b, share = rounded - a;
  return {factor * rounded, factor * ((a - (rounded - share)) + (b - share))};
}

/// What lies below a block: where it begins along every axis, seen from both ends.
struct Below {
  std::array<Real2, 3> lower{};
  std::array<Real2, 3> minus_upper{};
  std::size_t first = 0;
  std::size_t end = 0;  ///< the places of items are in [first, end)
  std::size_t items = 0;

  void add(const Below& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!(lower[axis] <= other.lower[axis])) lower[axis] = other.lower[axis];
      if (!(minus_upper[axis] <= other.minus_upper[axis])) minus_upper[axis] = other.minus_upper[axis];
    }
    first = items == 0 ? other.first : std::min(first, other.first);
    end = std::max(end, other.end);
    items += other.items;
  }
};

class WideChecker {
 public:
  /// Refers to all of them.
  WideChecker(const WideBvh& tree, std::size_t item_count, FunctionRef<Aabb(std::size_t item)> box)
      : tree_(tree), item_count_(item_count), box_(box) {}

  std::string fault() {
    if (tree_.items.size() != item_count_)
      return fmt::format("it has {} items, and there are {}", tree_.items.size(), item_count_);
    if (item_count_ == 0) return tree_.blocks.empty() ? "" : "it has blocks for no items";
    // A block without a block below has an item of its own, and all others but the last before an item have two.
    if (tree_.blocks.empty() || tree_.blocks.size() > 2 * item_count_)
      return fmt::format("{} blocks are not as many as {} items need", tree_.blocks.size(), item_count_);
    if (!frame_is_right()) return "its frame is not that of the items' box";
    if (!items_are_each_there_once()) return "its items are not each there once";
    if (!(tree_.built_size == -1 || (tree_.built_size >= 0 && std::isfinite(tree_.built_size))))
      return "its size when built is no size";
    return fault_of_blocks();
  }

 private:
  bool frame_is_right() {
    Aabb around;
    for (std::size_t item = 0; item < item_count_; ++item) around = merge(around, box_(item));
    frame_ = frame_around(around);
    reach_ = (frame_.unit < 0x1p1023 ? 1 : 2) * (1 + 0x1p-16);
    // Powers of two that lose nothing: a small one would take numbers below the least double.
    own_factor_ = std::max(frame_.unit, 1.0);
    item_factor_ = std::max(frame_.inverse, 1.0);
    return tree_.box == around && tree_.origin == frame_.origin && tree_.unit == frame_.unit;
  }

  bool items_are_each_there_once() const {
    std::vector<bool> seen(item_count_, false);
    for (const Index item : tree_.items) {
      if (item >= seen.size() || seen[item]) return false;
      seen[item] = true;
    }
    return true;
  }

  std::string fault_of_blocks() {
    below_.resize(tree_.blocks.size());
    has_parent_.assign(tree_.blocks.size(), false);
    // Children come after their parents.
    for (std::size_t block = tree_.blocks.size(); block-- > 0;) {
      if (!look_into(block)) return fmt::format("block {} does not hold what is below it", block);
      const Below& below = below_[block];
      if (below.end - below.first != below.items) return fmt::format("the items of block {} are not one run", block);
    }
    if (std::find(has_parent_.begin() + 1, has_parent_.end(), false) != has_parent_.end())
      return "a block is not below the first";
    return below_[0].items == item_count_ ? "" : "not all items are below the first block";
  }

  /// Finds what is below a block. False where a lane is wrong.
  bool look_into(std::size_t number) {
    const WideBlock& block = tree_.blocks[number];
    if (block.count < 1 || block.count > WideBlock::width) return false;
    for (std::size_t lane = 0; lane < WideBlock::width; ++lane) {
      if (lane >= block.count) {
        if (!is_unused(block, lane)) return false;
        continue;
      }
      if (!has_valid_child(number, lane)) return false;
      const Below below = below_lane(block, lane);
      if (!holds(block, lane, below)) return false;
      below_[number].add(below);
    }
    return true;
  }

  static bool is_unused(const WideBlock& block, std::size_t lane) {
    bool zero = block.child[lane] == 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      zero = zero && block.centre[axis][lane] == 0 && block.extent[axis][lane] == 0;
    return zero;
  }

  /// Takes note that a child block has a parent.
  bool has_valid_child(std::size_t number, std::size_t lane) {
    const WideBlock& block = tree_.blocks[number];
    if (block.is_item(lane)) return block.item_place(lane) < item_count_;
    const auto child = static_cast<std::size_t>(block.child[lane]);
    if (child <= number || child >= tree_.blocks.size() || has_parent_[child]) return false;
    has_parent_[child] = true;
    return true;
  }

  Below below_lane(const WideBlock& block, std::size_t lane) const {
    if (!block.is_item(lane)) return below_[static_cast<std::size_t>(block.child[lane])];
    const auto place = block.item_place(lane);
    const Aabb box = box_(tree_.items[place]);
    Below item;
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      item.lower[i] = sum(box.lower[axis], -frame_.origin[axis], item_factor_);
      item.minus_upper[i] = sum(-box.upper[axis], frame_.origin[axis], item_factor_);
    }
    item.first = place;
    item.end = place + 1;
    item.items = 1;
    return item;
  }

  /// Whether the lane's box holds the items below in real numbers, and is not far beyond all of them.
  bool holds(const WideBlock& block, std::size_t lane, const Below& below) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double centre{block.centre[axis][lane]}, extent{block.extent[axis][lane]};
      if (!(extent >= 0 && std::abs(centre) + extent <= reach_)) return false;
      if (!(sum(centre, -extent, own_factor_) <= below.lower[axis])) return false;
      if (!(sum(-centre, -extent, own_factor_) <= below.minus_upper[axis])) return false;
    }
    return true;
  }

  const WideBvh& tree_;
  std::size_t item_count_;
  FunctionRef<Aabb(std::size_t item)> box_;
  WideFrame frame_;
  double reach_ = 1;
  double own_factor_ = 1;
  double item_factor_ = 1;
  std::vector<Below> below_;
  std::vector<bool> has_parent_;
};

}  // namespace

std::string fault_of(const WideBvh& tree, std::span<const Aabb> boxes) {
  return WideChecker(tree, boxes.size(), [boxes](std::size_t item) { return boxes[item]; }).fault();
}

std::string fault_of(const WideBvh& tree, const TriangleMesh& mesh) {
  return WideChecker(tree, mesh.triangle_count(), [&](std::size_t item) { return triangle_box(mesh, item); }).fault();
}

}  // namespace toccata
