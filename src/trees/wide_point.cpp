// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/wide_point.hpp"

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
#include "trees/block_walk.hpp"
#include "trees/point_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

/// What is rounded in a square of floats: less than that, relatively.
constexpr float of_squares = 1 + 0x1p-19F;

float as_float(double x) { return static_cast<float>(x); }

/// Shows items by their places.
class VisitedLeaves {
 public:
  void start(const WideBvh& tree, const FunctionRef<double(std::span<const Index>)>& visit) {
    tree_ = &tree;
    visit_ = &visit;
  }

  /// Shows the items in these lanes of a block; returns the limit from then on.
  double see(std::size_t number, unsigned items) {
    std::array<Index, WideBlock::width> places;
    std::size_t count = 0;
    for (; items != 0; items &= items - 1)
      places[count++] =
          ~static_cast<Index>(tree_->blocks[number].child[static_cast<std::size_t>(std::countr_zero(items))]);
    return (*visit_)({places.data(), count});
  }
  void prefetch(std::size_t /*number*/) const {}

 private:
  const WideBvh* tree_;
  const FunctionRef<double(std::span<const Index>)>* visit_;
};

/// Bounds the distances of all triangles of a block at once.
class BoundedLeaves {
 public:
  void start(const LeafTriangles& leaves, const WidePoint& point, NearTriangles& near) {
    leaves_ = &leaves;
    near_ = &near;
    at_ = as_floats(point.at);
    pad_ = pad_of(leaves, point);
    count_ = 0;
  }

  double see(std::size_t number, unsigned items) {
    alignas(64) std::array<float, WideBlock::width> lower, upper;
    const TriangleLanes& triangles = leaves_->of_block[number];
    for (std::size_t first = 0; first < WideBlock::width; first += part_lanes) {
      const FloatBounds bounds = bounds_of(triangles, first, at_, pad_);
      hn::Store(bounds.lower, Floats(), lower.data() + first);
      hn::Store(bounds.upper, Floats(), upper.data() + first);
    }
    count_ += static_cast<std::size_t>(std::popcount(items));
    if (near_->k() == 1)
      near_->lower_limit(least_of(upper, items));
    else
      for (unsigned left = items; left != 0; left &= left - 1)
        near_->see_upper(upper[static_cast<std::size_t>(std::countr_zero(left))]);
    keep(triangles, items, lower);
    return static_cast<double>(near_->limit());
  }

  HWY_INLINE void prefetch(std::size_t number) const { toccata::prefetch(leaves_->of_block[number]); }

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
    near_->make_room();
    for (std::size_t first = 0; first < WideBlock::width; first += part_lanes) {
      const auto bound = hn::Load(d, lower.data() + first);
      const auto kept = hn::AndNot(hn::Gt(bound, hn::Set(d, near_->limit())), mask_from(first, items));
      const auto number = hn::Load(of_numbers, triangles.number.data() + first);
      hn::StoreU(hn::Compress(bound, kept), d, near_->lowers_place());
      hn::StoreU(hn::Compress(number, hn::RebindMask(of_numbers, kept)), of_numbers, near_->numbers_place());
      near_->claim(hn::CountTrue(d, kept));
    }
  }

  const LeafTriangles* leaves_;
  NearTriangles* near_;
  std::array<float, 3> at_;
  float pad_;
  std::size_t count_;
};

/// A search for what is within a limit of a point, which the leaves lower.
template <class Leaves>
class PointSearch {
 public:
  static constexpr ChildOrder child_order = ChildOrder::nearest_of_many;

  template <class... LeafParts>
  void start(const WidePoint& point, double limit, LeafParts&&... leaf_parts) {
    leaves_.start(leaf_parts...);
    at_ = as_floats(point.at);
    pad_ = point.pad + rounding_of(point.at);
    boxes_ = 0;
    keep_within(limit);
  }

  /// Compares the squares of how far boxes are. What is not a number keeps the lane.
  HWY_INLINE unsigned meet(const WideBlock& block, std::size_t first, LaneFloats& squared) {
    if (first == 0) boxes_ += block.count;
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
  [[nodiscard]] HWY_INLINE bool wants(float squared) const { return !(squared > limit_squared_); }
  HWY_INLINE void prefetch(std::size_t number) const { leaves_.prefetch(number); }
  HWY_INLINE void see(std::size_t number, unsigned items, const LaneFloats& /*squared*/) {
    keep_within(leaves_.see(number, items));
  }

  [[nodiscard]] std::size_t boxes() const { return boxes_; }
  [[nodiscard]] const Leaves& leaves() const { return leaves_; }

 private:
  /// At least what is rounded in the gaps along the axes, added up; boxes are within 2 of the origin. Three floats of
  /// |x| and at most 2 for the centre are rounded: x itself, the difference, and that less the extent.
  static double rounding_of(const Vec3& at) { return 0x1p-22 * (sum_of_magnitudes(at) + 8); }

  void keep_within(double limit) {
    const double length = (limit + pad_) * (1 + 0x1p-40), squared = length * length;
    limit_squared_ = limit < 0 ? -1 : squared < 0x1p126 ? static_cast<float>(squared) * of_squares : HUGE_VALF;
  }

  Leaves leaves_;
  std::array<float, 3> at_;
  double pad_;
  float limit_squared_;
  std::size_t boxes_;
};

std::size_t run_point(const WideBvh& tree, const WidePoint& point, double limit,
                      FunctionRef<double(std::span<const Index>)> visit) {
  BlockWalk<PointSearch<VisitedLeaves>> walk;
  walk.start(tree, point, limit, tree, visit);
  walk.run();
  return walk.search().boxes();
}

using NearPointWalk = BlockWalk<PointSearch<BoundedLeaves>>;

void add_counts(NearPointWalk& walk, PointCounts& counts) {
  counts.boxes += walk.search().boxes();
  counts.triangles += walk.search().leaves().count();
}

PointCounts run_near_point(const WideBvh& tree, const LeafTriangles& triangles, const WidePoint& point,
                           NearTriangles& near) {
  NearPointWalk walk;
  walk.start(tree, point, static_cast<double>(near.limit()), triangles, point, near);
  walk.run();
  PointCounts counts;
  add_counts(walk, counts);
  return counts;
}

PointCounts run_near_points(const WideBvh& tree, const LeafTriangles& leaves, std::span<const NearStart> starts,
                            std::array<NearTriangles::Memory, points_abreast>& memory,
                            FunctionRef<void(std::size_t, NearTriangles&)> done) {
  std::array<std::optional<NearTriangles>, points_abreast> near;
  std::array<std::size_t, points_abreast> numbers;
  PointCounts counts;
  const auto start = [&](NearPointWalk& walk, std::size_t place, std::size_t i) {
    const auto& [point, limit] = starts[i];
    near[place].emplace(1, limit, memory[place]);
    walk.start(tree, point, static_cast<double>(limit), leaves, point, *near[place]);
    numbers[place] = i;
  };
  const auto end = [&](NearPointWalk& walk, std::size_t place) {
    add_counts(walk, counts);
    done(numbers[place], *near[place]);
  };
  walk_abreast<NearPointWalk, points_abreast>(starts.size(), start, end);
  return counts;
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
