// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/gap_planes.hpp"

#include "math/floats.hpp"
#include "math/vec3_measures.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trees/gap_planes.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "trees/box_lanes.hpp"

#ifndef TOCCATA_TREES_GAP_PLANES_ONCE
#define TOCCATA_TREES_GAP_PLANES_ONCE
namespace toccata {

/// A view in floats, for `find_near`.
struct GapView {
  std::array<std::array<float, 3>, 3> columns;  ///< of ratio · rotation
  std::array<float, 3> offset;
  float pad;
};

}  // namespace toccata
#endif

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

static_assert(GapPlaneLanes::width == most_lanes);

using PlaneFloats = hn::CappedTag<float, GapPlanes::width>;
using PlaneFloat = hn::Vec<PlaneFloats>;
using PlaneVector = LaneVector<PlaneFloats>;

HWY_INLINE PlaneVector planes_at(const std::array<GapPlanes::Block::Lanes, 3>& lanes, std::size_t lane) {
  constexpr PlaneFloats floats;
  return {hn::Load(floats, lanes[0].data() + lane), hn::Load(floats, lanes[1].data() + lane),
          hn::Load(floats, lanes[2].data() + lane)};
}

HWY_INLINE PlaneFloat bound(const GapView& view, const GapPlanes::Block& block, std::size_t lane) {
  constexpr PlaneFloats floats;
  const PlaneVector n = planes_at(block.normal, lane);
  const PlaneVector seen{dot(in_all(floats, view.columns[0]), n), dot(in_all(floats, view.columns[1]), n),
                         dot(in_all(floats, view.columns[2]), n)};
  const PlaneVector turn = minus(seen, planes_at(block.turned, lane));
  const PlaneFloat swept = hn::Mul(hn::Sqrt(dot(turn, turn)), hn::Load(floats, block.radius.data() + lane));
  const PlaneFloat middle = hn::Add(dot(n, in_all(floats, view.offset)), dot(seen, planes_at(block.centre, lane)));
  return hn::Sub(hn::Sub(middle, hn::Load(floats, block.reach.data() + lane)),
                 hn::Add(swept, hn::Set(floats, view.pad)));
}

/// What is not a number is near.
void near_planes(const GapView& view, std::span<const GapPlanes::Block> blocks, float limit,
                 std::vector<GapPlanes::Near>& near) {
  constexpr PlaneFloats floats;
  alignas(64) std::array<float, GapPlanes::width> bounds;
  for (std::size_t number = 0; number < blocks.size(); ++number) {
    unsigned waiting = 0;
    for (std::size_t lane = 0; lane < GapPlanes::width; lane += hn::Lanes(floats)) {
      const PlaneFloat least = bound(view, blocks[number], lane);
      hn::Store(least, floats, bounds.data() + lane);
      waiting |= bits_of(floats, hn::Not(hn::Gt(least, hn::Set(floats, limit)))) << lane;
    }
    for (; waiting != 0; waiting &= waiting - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(waiting));
      near.push_back({static_cast<std::uint32_t>(number * GapPlanes::width + lane), bounds[lane]});
    }
  }
}

struct TurnedBox {
  Vector centre, extent;
  std::array<Vector, 3> axis;
};

HWY_INLINE TurnedBox box_of(const OrientedBlock& block, std::size_t lane) {
  const Vector first = loaded(block.axis[0], lane), second = loaded(block.axis[1], lane);
  return {loaded(block.centre, lane), loaded(block.extent, lane), {first, second, cross(first, second)}};
}

HWY_INLINE Vector transposed_times(const Mat3& m, const Vector& v) {
  return {dot(in_all(m.column(0)), v), dot(in_all(m.column(1)), v), dot(in_all(m.column(2)), v)};
}

/// A box of the second tree, as seen from the first.
HWY_INLINE TurnedBox seen(const NearView& view, const TurnedBox& box) {
  const Number ratio = hn::Set(tag, view.ratio);
  const Vector first = turned(view.rotation, box.axis[0]), second = turned(view.rotation, box.axis[1]);
  return {plus(in_all(view.offset), times(ratio, turned(view.rotation, box.centre))),
          times(ratio, box.extent),
          {first, second, cross(first, second)}};
}

/// How far a box reaches from its centre in a direction.
HWY_INLINE Number support(const TurnedBox& box, const Vector& direction) {
  return hn::Add(hn::Add(hn::Mul(box.extent.x, hn::Abs(dot(box.axis[0], direction))),
                         hn::Mul(box.extent.y, hn::Abs(dot(box.axis[1], direction)))),
                 hn::Mul(box.extent.z, hn::Abs(dot(box.axis[2], direction))));
}

struct TurnedWayOut {
  Vector direction;
  Number squared;
};

/// From a box to the smallest one along its axes that holds the other, `between` being the way to the other's centre.
HWY_INLINE TurnedWayOut way_out_of(const TurnedBox& own, const TurnedBox& other, const Vector& between) {
  const Number zero = hn::Zero(tag);
  const std::array<Number, 3> extent{own.extent.x, own.extent.y, own.extent.z};
  TurnedWayOut way{{zero, zero, zero}, zero};
  for (std::size_t i = 0; i < 3; ++i) {
    const Number along = dot(own.axis[i], between);
    const Number gap = hn::Max(hn::Sub(hn::Sub(hn::Abs(along), extent[i]), support(other, own.axis[i])), zero);
    way.squared = hn::Add(way.squared, hn::Mul(gap, gap));
    way.direction = plus(way.direction, times(hn::CopySign(gap, along), own.axis[i]));
  }
  return way;
}

/// The direction in which they seem to be farthest apart, of length 1; 0 where there is none.
HWY_INLINE Vector separating_direction(const TurnedBox& own, const TurnedBox& other, const Vector& between) {
  const TurnedWayOut by_own = way_out_of(own, other, between);
  const TurnedWayOut by_other = way_out_of(other, own, between);
  const Number squared = dot(between, between);
  const Number left = hn::Max(hn::Sub(hn::Sub(squared, support(own, between)), support(other, between)), hn::Zero(tag));
  const auto own_first = hn::Ge(by_own.squared, by_other.squared);
  const Number by_sides = hn::Max(by_own.squared, by_other.squared);
  const auto centres_first = hn::Gt(hn::Mul(left, left), hn::Mul(by_sides, squared));
  const Vector direction = select(centres_first, between, select(own_first, by_own.direction, by_other.direction));
  const Number length = hn::Sqrt(dot(direction, direction));
  const auto some = hn::Gt(length, hn::Zero(tag));
  return times(hn::IfThenElseZero(some, hn::Div(hn::Set(tag, 1), length)), direction);
}

HWY_INLINE Number rounded(const Number& value, float* to) {
  const hn::Rebind<float, Tag> floats;
  const auto narrow = hn::DemoteTo(floats, value);
  hn::StoreU(narrow, floats, to);
  return hn::PromoteTo(tag, narrow);
}
HWY_INLINE Vector rounded(const Vector& v, std::array<GapPlaneLanes::Lanes, 3>& to, std::size_t lane) {
  return {rounded(v.x, to[0].data() + lane), rounded(v.y, to[1].data() + lane), rounded(v.z, to[2].data() + lane)};
}
/// Not below a number of at most some hundreds, computed in doubles.
HWY_INLINE Number rounded_up(const Number& value, float* to) {
  const Number size = hn::Add(hn::Abs(value), hn::Set(tag, 1e-6));
  return rounded(hn::Add(value, hn::Mul(size, hn::Set(tag, 0x1p-22))), to);
}

/// The boxes of the first tree and of the second in the same lanes.
void part_paired_boxes(const NearView& view, const OrientedBlock& first, const OrientedBlock& second,
                       GapPlaneLanes& planes) {
  for (std::size_t lane = 0; lane < GapPlaneLanes::width; lane += hn::Lanes(tag)) {
    const TurnedBox own = box_of(first, lane), local = box_of(second, lane), other = seen(view, local);
    const Vector between = minus(other.centre, own.centre);
    const Vector normal = rounded(separating_direction(own, other, between), planes.normal, lane);
    const Vector turned_now = times(hn::Set(tag, view.ratio), transposed_times(view.rotation, normal));
    const Vector turned = rounded(turned_now, planes.turned, lane), turn = minus(turned_now, turned);
    // The axes are orthonormal up to 2^-21.
    const Number size = hn::Mul(hn::Sqrt(dot(local.extent, local.extent)), hn::Set(tag, 1 + 0x1p-18));
    const Number radius = rounded_up(size, planes.radius.data() + lane);
    const Number reach =
        rounded_up(hn::Add(dot(normal, own.centre), hn::Add(support(own, normal), support(local, turned))),
                   planes.reach.data() + lane);
    const Number middle = hn::Add(dot(normal, in_all(view.offset)), dot(turned_now, local.centre));
    const Number swept = hn::Mul(hn::Sqrt(dot(turn, turn)), radius);
    hn::StoreU(hn::Sub(hn::Sub(middle, reach), hn::Add(swept, hn::Set(tag, view.pad))), tag,
               planes.least.data() + lane);
  }
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

// Calls what was compiled for the level that is in use.
HWY_EXPORT(near_planes);
HWY_EXPORT(part_paired_boxes);

/// Into so many lanes, from one on.
template <std::size_t count>
void put_box(const NearBvh& tree, std::uint32_t box, OrientedBlock& to, std::size_t lane) {
  const OrientedBlock& block = tree.blocks[box >> 3];
  const std::size_t from = box & 7U;
  for (std::size_t i = 0; i < 3; ++i) {
    std::fill_n(to.centre[i].data() + lane, count, block.centre[i][from]);
    std::fill_n(to.axis[0][i].data() + lane, count, block.axis[0][i][from]);
    std::fill_n(to.axis[1][i].data() + lane, count, block.axis[1][i][from]);
    std::fill_n(to.extent[i].data() + lane, count, block.extent[i][from]);
  }
}

void part_lanes_of(const NearWalk& walk, const OrientedBlock& first, const OrientedBlock& second,
                   GapPlaneLanes& planes) {
  planes.centre = second.centre;
  HWY_DYNAMIC_DISPATCH(part_paired_boxes)(walk.view(0), first, second, planes);
}

}  // namespace

double plane_pad(const NearView& view) {
  return view.pad + 0x1p-19 * (4 + (4 * view.ratio + sum_of_magnitudes(view.offset)));
}

void GapPlanes::clear() {
  blocks_.clear();
  size_ = 0;
}

std::uint32_t GapPlanes::add() {
  if (size_ == blocks_.size() * width) {
    blocks_.push_back({});
    blocks_.back().reach.fill(-infinite_float);
  }
  return static_cast<std::uint32_t>(size_++);
}

void GapPlanes::set(std::uint32_t place, const GapPlane& plane) {
  Block& block = blocks_[place / width];
  const std::size_t lane = place % width;
  for (std::size_t i = 0; i < 3; ++i) {
    block.normal[i][lane] = plane.normal[i];
    block.turned[i][lane] = plane.turned[i];
    block.centre[i][lane] = plane.centre[i];
  }
  block.radius[lane] = plane.radius;
  block.reach[lane] = plane.reach;
}

void GapPlanes::set(std::uint32_t place, const GapPlaneLanes& planes, std::size_t from) {
  Block& block = blocks_[place / width];
  const std::size_t lane = place % width;
  for (std::size_t i = 0; i < 3; ++i) {
    block.normal[i][lane] = planes.normal[i][from];
    block.turned[i][lane] = planes.turned[i][from];
    block.centre[i][lane] = planes.centre[i][from];
  }
  block.radius[lane] = planes.radius[from];
  block.reach[lane] = planes.reach[from];
}

void GapPlanes::unset(std::uint32_t place) { blocks_[place / width].reach[place % width] = -infinite_float; }

void GapPlanes::find_near(const NearView& view, double limit, std::vector<Near>& near) const {
  GapView floats{};
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Vec3 column = view.ratio * view.rotation.column(i);
    floats.columns[at] = {static_cast<float>(column.x), static_cast<float>(column.y), static_cast<float>(column.z)};
    floats.offset[at] = static_cast<float>(view.offset[i]);
  }
  floats.pad = up_to_float(plane_pad(view));
  // Places that are not set are infinitely far apart.
  const float within = std::min(up_to_float(limit), std::numeric_limits<float>::max());
  HWY_DYNAMIC_DISPATCH(near_planes)(floats, blocks_, within, near);
}

void part_boxes(const NearWalk& walk, std::span<const BoxPair> pairs, GapPlaneLanes& planes) {
  OrientedBlock first, second;
  for (std::size_t lane = 0; lane < GapPlaneLanes::width; ++lane) {
    const BoxPair& pair = pairs[lane < pairs.size() ? lane : 0];
    put_box<1>(walk.tree(0), pair.first, first, lane);
    put_box<1>(walk.tree(1), pair.second, second, lane);
  }
  part_lanes_of(walk, first, second, planes);
}

void part_children(const NearWalk& walk, std::size_t side, std::uint32_t number, std::uint32_t other,
                   GapPlaneLanes& planes) {
  const OrientedBlock& block = walk.tree(side).blocks[number];
  OrientedBlock everywhere;
  put_box<GapPlaneLanes::width>(walk.tree(side ^ 1), other, everywhere, 0);
  part_lanes_of(walk, side == 0 ? block : everywhere, side == 0 ? everywhere : block, planes);
}

}  // namespace toccata
#endif
