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
#include <optional>

#include "math/floats.hpp"
#include "math/vec3_measures.hpp"
#include "trees/block_lanes.hpp"
#include "trees/point_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

using Integers = hn::CappedTag<std::int32_t, WideBlock::width>;
alignas(64) constexpr std::array<std::int32_t, WideBlock::width> lane_bit{1, 2, 4, 8, 16, 32, 64, 128};

/// What is rounded in a square of floats, and the last three bits of those that wait, which tell lanes apart: less than
/// that, relatively.
constexpr float of_squares = 1 + 0x1p-19F;

float as_float(double x) { return static_cast<float>(x); }

template <class Value>
HWY_INLINE void prefetch_all(const Value& value) {
  const auto* bytes = reinterpret_cast<const char*>(&value);
#pragma GCC unroll 8
  for (std::size_t line = 0; line < sizeof(Value); line += 64) __builtin_prefetch(bytes + line);
}

/// Shows items by their places.
class VisitedLeaves {
 public:
  VisitedLeaves(const WideBvh& tree, FunctionRef<double(std::span<const Index>)> visit) : tree_(tree), visit_(visit) {}

  /// Of a block the items in these lanes; returns the limit from then on.
  double see(std::size_t number, unsigned items) {
    std::array<Index, WideBlock::width> places;
    std::size_t count = 0;
    for (; items != 0; items &= items - 1)
      places[count++] =
          ~static_cast<Index>(tree_.blocks[number].child[static_cast<std::size_t>(std::countr_zero(items))]);
    return visit_({places.data(), count});
  }
  void prefetch(std::size_t /*number*/) const {}

 private:
  const WideBvh& tree_;
  FunctionRef<double(std::span<const Index>)> visit_;
};

/// Bounds the distances of all triangles of a block at once.
class BoundedLeaves {
 public:
  BoundedLeaves(const LeafTriangles& leaves, const WidePoint& point, NearTriangles& near)
      : leaves_(leaves), near_(near), at_(as_floats(point.at)), pad_(pad_of(leaves, point)) {}

  double see(std::size_t number, unsigned items) {
    alignas(64) std::array<float, WideBlock::width> lower, upper;
    const TriangleLanes& triangles = leaves_.of_block[number];
    for (std::size_t first = 0; first < WideBlock::width; first += part_lanes) {
      const FloatBounds bounds = bounds_of(triangles, first, at_, pad_);
      hn::Store(bounds.lower, Floats(), lower.data() + first);
      hn::Store(bounds.upper, Floats(), upper.data() + first);
    }
    count_ += static_cast<std::size_t>(std::popcount(items));
    if (near_.k() == 1)
      near_.lower_limit(least_of(upper, items));
    else
      for (unsigned left = items; left != 0; left &= left - 1)
        near_.see_upper(upper[static_cast<std::size_t>(std::countr_zero(left))]);
    keep(triangles, items, lower);
    return static_cast<double>(near_.limit());
  }

  HWY_INLINE void prefetch(std::size_t number) const { prefetch_all(leaves_.of_block[number]); }

  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  /// That of the corners and of the point, √3 times along an axis, and of the bounds' own roundings where they are too
  /// small for floats.
  static float pad_of(const LeafTriangles& leaves, const WidePoint& point) {
    const double off = 2 * static_cast<double>(leaves.off) + 0x1p-24 * sum_of_magnitudes(point.at);
    return as_float((point.pad + off) * (1 + 0x1p-20) + 0x1p-30);
  }

  static HWY_INLINE hn::Mask<Floats> mask_from(std::size_t first, unsigned bits) {
    const std::uint8_t some[8] = {static_cast<std::uint8_t>(bits >> first)};
    return hn::LoadMaskBits(Floats(), some);
  }

  static HWY_INLINE float least_of(const std::array<float, WideBlock::width>& upper, unsigned items) {
    const Floats d;
    auto least = hn::Inf(d);
    for (std::size_t first = 0; first < WideBlock::width; first += part_lanes)
      least = hn::Min(least, hn::IfThenElse(mask_from(first, items), hn::Load(d, upper.data() + first), hn::Inf(d)));
    return hn::GetLane(hn::MinOfLanes(d, least));
  }

  /// Those that are within the limit, which is known by now.
  HWY_INLINE void keep(const TriangleLanes& triangles, unsigned items,
                       const std::array<float, WideBlock::width>& lower) {
    const Floats d;
    const hn::RebindToUnsigned<Floats> of_numbers;
    near_.make_room();
    for (std::size_t first = 0; first < WideBlock::width; first += part_lanes) {
      const auto bound = hn::Load(d, lower.data() + first);
      const auto kept = hn::AndNot(hn::Gt(bound, hn::Set(d, near_.limit())), mask_from(first, items));
      const auto number = hn::Load(of_numbers, triangles.number.data() + first);
      hn::StoreU(hn::Compress(bound, kept), d, near_.lowers_place());
      hn::StoreU(hn::Compress(number, hn::RebindMask(of_numbers, kept)), of_numbers, near_.numbers_place());
      near_.claim(hn::CountTrue(d, kept));
    }
  }

  const LeafTriangles& leaves_;
  NearTriangles& near_;
  std::array<float, 3> at_;
  float pad_;
  std::size_t count_ = 0;
};

template <class Leaves>
class PointWalk {
 public:
  PointWalk(const WideBvh& tree, const WidePoint& point, double limit, const Leaves& leaves)
      : tree_(tree), leaves_(leaves), at_(as_floats(point.at)), pad_(point.pad + rounding_of(point.at)) {
    keep_within(limit);
  }

  /// Opens a block; false when there is nothing more.
  HWY_INLINE bool step() {
    open(static_cast<std::size_t>(child_));
    return next();
  }

  void run() {
    while (step())
      if (!pending_.empty()) prefetch(pending_.top().child);
  }

  /// Asks for the memory of the next block before its turn comes.
  HWY_INLINE void prefetch_next() const { prefetch(child_); }

  [[nodiscard]] std::size_t boxes() const { return boxes_; }
  [[nodiscard]] const Leaves& leaves() const { return leaves_; }

 private:
  /// At least what is rounded in the gaps along the axes, added up; boxes are within 2 of the origin. Of |x| and at
  /// most 2 for the centre, three floats are rounded: x itself, the difference, and that less the extent.
  static double rounding_of(const Vec3& at) { return 0x1p-22 * (sum_of_magnitudes(at) + 8); }

  void keep_within(double limit) {
    const double length = (limit + pad_) * (1 + 0x1p-40), squared = length * length;
    limit_squared_ = limit < 0 ? -1 : squared < 0x1p126 ? static_cast<float>(squared) * of_squares : HUGE_VALF;
  }

  HWY_INLINE void open(std::size_t number) {
    const WideBlock& block = tree_.blocks[number];
    alignas(64) std::array<float, WideBlock::width> squared;
    unsigned near = 0, items = 0;
    for (std::size_t part = 0; part < block_parts; ++part) {
      near |= measure(block, part * part_lanes, squared) << part * part_lanes;
      items |= items_of(block, part * part_lanes) << part * part_lanes;
    }
    near &= (1U << block.count) - 1U;
    boxes_ += block.count;
    if ((near & items) != 0) keep_within(leaves_.see(number, near & items));
    if ((near & ~items) != 0) wait(block, near & ~items, squared);
  }

  static HWY_INLINE unsigned items_of(const WideBlock& block, std::size_t first) {
    const Integers d;
    return bits_of(d, hn::Lt(hn::Load(d, block.child.data() + first), hn::Zero(d)));
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

  HWY_INLINE void prefetch(std::int32_t child) const {
    prefetch_all(tree_.blocks[static_cast<std::size_t>(child)]);
    leaves_.prefetch(static_cast<std::size_t>(child));
  }

  /// The next that waits and is still of interest.
  HWY_INLINE bool next() {
    while (!pending_.empty()) {
      const Pending one = pending_.pop();
      child_ = one.child;
      if (!(one.when > limit_squared_)) return true;
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
    return ~bits_of(d, hn::Gt(sum, hn::Set(d, limit_squared_))) & part_mask;
  }

  const WideBvh& tree_;
  Leaves leaves_;
  std::array<float, 3> at_;
  double pad_;
  float limit_squared_ = 0;
  std::int32_t child_ = 0;
  std::size_t boxes_ = 0;
  PendingStack pending_;
};

std::size_t run_point(const WideBvh& tree, const WidePoint& point, double limit,
                      FunctionRef<double(std::span<const Index>)> visit) {
  PointWalk walk(tree, point, limit, VisitedLeaves(tree, visit));
  walk.run();
  return walk.boxes();
}

using NearPointWalk = PointWalk<BoundedLeaves>;

PointCounts counts_of(const NearPointWalk& walk) { return {walk.boxes(), walk.leaves().count()}; }

PointCounts run_near_point(const WideBvh& tree, const LeafTriangles& triangles, const WidePoint& point,
                           NearTriangles& near) {
  NearPointWalk walk(tree, point, static_cast<double>(near.limit()), BoundedLeaves(triangles, point, near));
  walk.run();
  return counts_of(walk);
}

/// Points that walk side by side, the next one in the place of one that is done.
class NearPointWalks {
 public:
  NearPointWalks(const WideBvh& tree, const LeafTriangles& leaves, std::span<const NearStart> starts,
                 std::array<NearTriangles::Memory, points_abreast>& memory)
      : tree_(tree), leaves_(leaves), starts_(starts), memory_(memory) {}

  PointCounts run(FunctionRef<void(std::size_t, NearTriangles&)> done) {
    for (std::size_t i = 0; i < places_.size(); ++i) start_next(i);
    while (walking_ > 0)
      for (std::size_t i = 0; i < places_.size(); ++i) {
        if (!places_[i].walk) continue;
        if (places_[i].walk->step())
          places_[i].walk->prefetch_next();
        else
          end(i, done);
      }
    return counts_;
  }

 private:
  struct Place {
    std::optional<NearTriangles> near;
    std::optional<NearPointWalk> walk;
    std::size_t number = 0;
  };

  void start_next(std::size_t i) {
    if (next_ == starts_.size()) return;
    const NearStart& start = starts_[next_];
    Place& place = places_[i];
    place.near.emplace(1, start.limit, memory_[i]);
    place.walk.emplace(tree_, start.point, static_cast<double>(start.limit),
                       BoundedLeaves(leaves_, start.point, *place.near));
    place.number = next_++;
    ++walking_;
  }

  void end(std::size_t i, FunctionRef<void(std::size_t, NearTriangles&)> done) {
    Place& place = places_[i];
    const PointCounts counts = counts_of(*place.walk);
    counts_.boxes += counts.boxes;
    counts_.triangles += counts.triangles;
    done(place.number, *place.near);
    place.walk.reset();
    --walking_;
    start_next(i);
  }

  const WideBvh& tree_;
  const LeafTriangles& leaves_;
  std::span<const NearStart> starts_;
  std::array<NearTriangles::Memory, points_abreast>& memory_;
  std::size_t next_ = 0, walking_ = 0;
  PointCounts counts_;
  std::array<Place, points_abreast> places_;
};

PointCounts run_near_points(const WideBvh& tree, const LeafTriangles& leaves, std::span<const NearStart> starts,
                            std::array<NearTriangles::Memory, points_abreast>& memory,
                            FunctionRef<void(std::size_t, NearTriangles&)> done) {
  return NearPointWalks(tree, leaves, starts, memory).run(done);
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(run_point);
HWY_EXPORT(run_near_point);
HWY_EXPORT(run_near_points);

}  // namespace

std::size_t walk_point(const WideBvh& tree, const WidePoint& point, double limit,
                       FunctionRef<double(std::span<const Index>)> visit) {
  if (tree.blocks.empty()) return 0;
  return HWY_DYNAMIC_DISPATCH(run_point)(tree, point, limit, visit);
}

PointCounts find_near(const WideBvh& tree, const LeafTriangles& leaves, const WidePoint& point, NearTriangles& near) {
  if (tree.blocks.empty()) return {};
  return HWY_DYNAMIC_DISPATCH(run_near_point)(tree, leaves, point, near);
}

PointCounts find_near_each(const WideBvh& tree, const LeafTriangles& leaves, std::span<const NearStart> starts,
                           std::array<NearTriangles::Memory, points_abreast>& memory,
                           FunctionRef<void(std::size_t, NearTriangles&)> done) {
  if (tree.blocks.empty()) return {};
  return HWY_DYNAMIC_DISPATCH(run_near_points)(tree, leaves, starts, memory, done);
}

}  // namespace toccata
#endif
