// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/wide_point.hpp"

#include "trees/pending_stack.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trees/wide_point.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WideBlock::width>;
constexpr std::size_t lanes = hn::MaxLanes(Floats()), parts = WideBlock::width / lanes;
constexpr unsigned part_mask = (1U << lanes) - 1U;

using Integers = hn::CappedTag<std::int32_t, WideBlock::width>;
alignas(64) constexpr std::array<std::int32_t, WideBlock::width> lane_bit{1, 2, 4, 8, 16, 32, 64, 128};

/// What is rounded in a square of floats, and the last three bits of those that wait, which tell lanes apart: less than
/// that, relatively.
constexpr float of_squares = 1 + 0x1p-19F;

float as_float(double x) { return static_cast<float>(x); }

class PointWalk {
 public:
  PointWalk(const WideTree& tree, const WidePoint& point, double limit)
      : tree_(tree),
        at_{as_float(point.at.x), as_float(point.at.y), as_float(point.at.z)},
        pad_(point.pad + rounding_of(point.at)) {
    keep_within(limit);
  }

  std::size_t run(FunctionRef<double(std::span<const Index>)> visit) {
    std::int32_t child = 0;
    do open(tree_.blocks[static_cast<std::size_t>(child)], visit);
    while (next(child));
    return boxes_;
  }

 private:
  /// At least what is rounded in the gaps along the axes, added up; boxes are within 2 of the origin. Of |x| and at
  /// most 2 for the centre, three floats are rounded: x itself, the difference, and that less the extent.
  static double rounding_of(const Vec3& at) {
    return 0x1p-22 * (((std::fabs(at.x) + std::fabs(at.y)) + std::fabs(at.z)) + 8);
  }

  void keep_within(double limit) {
    const double length = (limit + pad_) * (1 + 0x1p-40), squared = length * length;
    limit_squared_ = limit < 0 ? -1 : squared < 0x1p126 ? static_cast<float>(squared) * of_squares : HUGE_VALF;
  }

  void open(const WideBlock& block, FunctionRef<double(std::span<const Index>)> visit) {
    alignas(64) std::array<float, WideBlock::width> squared;
    unsigned near = 0;
    for (std::size_t part = 0; part < parts; ++part) near |= measure(block, part * lanes, squared) << part * lanes;
    near &= (1U << block.count) - 1U;
    boxes_ += block.count;
    std::array<Index, WideBlock::width> items;
    std::size_t count = 0;
    unsigned inner = 0;
    for (; near != 0; near &= near - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(near));
      const std::int32_t child = block.child[lane];
      if (child < 0)
        items[count++] = ~static_cast<Index>(child);
      else
        inner |= 1U << lane;
    }
    if (count > 0) keep_within(visit({items.data(), count}));
    if (inner != 0) wait(block, inner, squared);
  }

  /// The nearest comes next. Sorted without branches, which could not be foreseen: each is put where the number of
  /// farther ones says. Those that do not wait come last, and are not claimed.
  HWY_INLINE void wait(const WideBlock& block, unsigned inner, const std::array<float, WideBlock::width>& squared) {
    const Integers d;
    const hn::Rebind<float, Integers> f;
    alignas(64) std::array<std::int32_t, WideBlock::width> key, place;
    for (std::size_t first = 0; first < WideBlock::width; first += hn::Lanes(d)) {
      const auto lane = hn::Iota(d, static_cast<std::int32_t>(first));
      const auto bits = hn::And(hn::BitCast(d, hn::Load(f, squared.data() + first)), hn::Set(d, 0x7FFFFFF8));
      const auto bit = hn::Load(d, lane_bit.data() + first);
      const auto waits = hn::Eq(hn::And(hn::Set(d, static_cast<std::int32_t>(inner)), bit), bit);
      hn::Store(hn::IfThenElse(waits, hn::Or(bits, lane), hn::Not(lane)), d, key.data() + first);
    }
    for (std::size_t first = 0; first < WideBlock::width; first += hn::Lanes(d)) {
      const auto own = hn::Load(d, key.data() + first);
      auto farther = hn::Zero(d);
      for (const std::int32_t other : key)
        farther = hn::Sub(farther, hn::VecFromMask(d, hn::Gt(hn::Set(d, other), own)));
      hn::Store(farther, d, place.data() + first);
    }
    pending_.make_room();
    for (std::size_t lane = 0; lane < WideBlock::width; ++lane)
      pending_.put(static_cast<std::size_t>(place[lane]), {std::bit_cast<float>(key[lane]), block.child[lane]});
    pending_.claim(static_cast<std::size_t>(std::popcount(inner)));
  }

  /// Asks for the memory of a block before its turn comes.
  HWY_INLINE void prefetch(std::int32_t child) const {
    const auto* bytes = reinterpret_cast<const char*>(&tree_.blocks[static_cast<std::size_t>(child)]);
    for (std::size_t line = 0; line < sizeof(WideBlock); line += 64) __builtin_prefetch(bytes + line);
  }

  /// The next that waits and is still of interest.
  bool next(std::int32_t& child) {
    while (!pending_.empty()) {
      const Pending one = pending_.pop();
      child = one.child;
      if (one.when > limit_squared_) continue;
      if (!pending_.empty()) prefetch(pending_.top().child);
      return true;
    }
    return false;
  }

  /// The squares of how far boxes are, and which of them are within the limit. What is not a number keeps the lane.
  HWY_INLINE unsigned measure(const WideBlock& block, std::size_t first,
                              std::array<float, WideBlock::width>& squared) const {
    const Floats d;
    const auto gap = [&](std::size_t axis) HWY_ATTR {
      const auto from = hn::Sub(hn::Load(d, block.centre[axis].data() + first), hn::Set(d, at_[axis]));
      const auto one = hn::Max(hn::Sub(hn::Abs(from), hn::Load(d, block.extent[axis].data() + first)), hn::Zero(d));
      return hn::Mul(one, one);
    };
    const auto sum = hn::Add(hn::Add(gap(0), gap(1)), gap(2));
    hn::Store(sum, d, squared.data() + first);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Gt(sum, hn::Set(d, limit_squared_)), bits);
    return ~static_cast<unsigned>(bits[0]) & part_mask;
  }

  const WideTree& tree_;
  std::array<float, 3> at_;
  double pad_;
  float limit_squared_ = 0;
  std::size_t boxes_ = 0;
  PendingStack pending_;
};

std::size_t run_point(const WideTree& tree, const WidePoint& point, double limit,
                      FunctionRef<double(std::span<const Index>)> visit) {
  return PointWalk(tree, point, limit).run(visit);
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(run_point);

}  // namespace

std::size_t walk_point(const WideTree& tree, const WidePoint& point, double limit,
                       FunctionRef<double(std::span<const Index>)> visit) {
  if (tree.blocks.empty()) return 0;
  return HWY_DYNAMIC_DISPATCH(run_point)(tree, point, limit, visit);
}

}  // namespace toccata
#endif
