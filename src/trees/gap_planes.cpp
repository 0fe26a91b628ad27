// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/gap_planes.hpp"

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

#ifndef TOCCATA_TREES_GAP_PLANES_ONCE
#define TOCCATA_TREES_GAP_PLANES_ONCE
namespace toccata {

/// A view in floats, for `find_near`.
struct PlaneView {
  std::array<std::array<float, 3>, 3> columns;  ///< of ratio · rotation
  std::array<float, 3> offset;
  float pad;
};

/// Boxes of both trees by lanes.
struct BoxLanes {
  using Numbers = GapPlaneLanes::Lanes;
  struct Side {
    std::array<Numbers, 3> centre, first, second, extent;
  };
  alignas(64) std::array<Side, 2> side;
};

}  // namespace toccata
#endif

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// No multiplication is fused with an addition, so that all levels find the same.

template <class Tag>
struct Lanes {
  using Number = hn::Vec<Tag>;
  struct Vector {
    Number x, y, z;
  };

  static HWY_INLINE Vector in_all(double x, double y, double z) {
    using Value = hn::TFromD<Tag>;
    return {hn::Set(Tag(), static_cast<Value>(x)), hn::Set(Tag(), static_cast<Value>(y)),
            hn::Set(Tag(), static_cast<Value>(z))};
  }
  static HWY_INLINE Vector in_all(const Vec3& v) { return in_all(v.x, v.y, v.z); }
  static HWY_INLINE Vector in_all(const std::array<float, 3>& v) { return in_all(v[0], v[1], v[2]); }
  static HWY_INLINE Vector minus(const Vector& u, const Vector& v) {
    return {hn::Sub(u.x, v.x), hn::Sub(u.y, v.y), hn::Sub(u.z, v.z)};
  }
  static HWY_INLINE Vector plus(const Vector& u, const Vector& v) {
    return {hn::Add(u.x, v.x), hn::Add(u.y, v.y), hn::Add(u.z, v.z)};
  }
  static HWY_INLINE Vector times(const Number& factor, const Vector& v) {
    return {hn::Mul(factor, v.x), hn::Mul(factor, v.y), hn::Mul(factor, v.z)};
  }
  static HWY_INLINE Number dot(const Vector& u, const Vector& v) {
    return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
  }
  static HWY_INLINE Vector cross(const Vector& u, const Vector& v) {
    return {hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)), hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
            hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
  }
  static HWY_INLINE Vector chosen(hn::Mask<Tag> yes, const Vector& u, const Vector& v) {
    return {hn::IfThenElse(yes, u.x, v.x), hn::IfThenElse(yes, u.y, v.y), hn::IfThenElse(yes, u.z, v.z)};
  }
};

using FloatTag = hn::CappedTag<float, GapPlanes::width>;
using Floats = Lanes<FloatTag>;

HWY_INLINE Floats::Vector loaded(const std::array<GapPlanes::Block::Lanes, 3>& lanes, std::size_t lane) {
  const FloatTag tag;
  return {hn::Load(tag, lanes[0].data() + lane), hn::Load(tag, lanes[1].data() + lane),
          hn::Load(tag, lanes[2].data() + lane)};
}

HWY_INLINE Floats::Number bound(const PlaneView& view, const GapPlanes::Block& block, std::size_t lane) {
  using F = Floats;
  const FloatTag tag;
  const F::Vector n = loaded(block.normal, lane);
  const F::Vector seen{F::dot(F::in_all(view.columns[0]), n), F::dot(F::in_all(view.columns[1]), n),
                       F::dot(F::in_all(view.columns[2]), n)};
  const F::Vector turn = F::minus(seen, loaded(block.turned, lane));
  const F::Number swept = hn::Mul(hn::Sqrt(F::dot(turn, turn)), hn::Load(tag, block.radius.data() + lane));
  const F::Number middle = hn::Add(F::dot(n, F::in_all(view.offset)), F::dot(seen, loaded(block.centre, lane)));
  return hn::Sub(hn::Sub(middle, hn::Load(tag, block.reach.data() + lane)), hn::Add(swept, hn::Set(tag, view.pad)));
}

/// What is not a number is near.
void near_planes(const PlaneView& view, std::span<const GapPlanes::Block> blocks, float limit,
                 std::vector<GapPlanes::Near>& near) {
  const FloatTag tag;
  alignas(64) std::array<float, GapPlanes::width> bounds;
  for (std::size_t number = 0; number < blocks.size(); ++number) {
    std::uint64_t waiting = 0;
    for (std::size_t lane = 0; lane < GapPlanes::width; lane += hn::Lanes(tag)) {
      const Floats::Number least = bound(view, blocks[number], lane);
      std::array<std::uint8_t, 8> bits{};
      hn::StoreMaskBits(tag, hn::Not(hn::Gt(least, hn::Set(tag, limit))), bits.data());
      hn::Store(least, tag, bounds.data() + lane);
      waiting |= std::bit_cast<std::uint64_t>(bits) << lane;
    }
    for (; waiting != 0; waiting &= waiting - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(waiting));
      near.push_back({static_cast<std::uint32_t>(number * GapPlanes::width + lane), bounds[lane]});
    }
  }
}

using DoubleTag = hn::CappedTag<double, GapPlaneLanes::width>;
using Doubles = Lanes<DoubleTag>;

HWY_INLINE Doubles::Vector loaded(const std::array<BoxLanes::Numbers, 3>& lanes, std::size_t lane) {
  const hn::Rebind<float, DoubleTag> from;
  const DoubleTag to;
  return {hn::PromoteTo(to, hn::LoadU(from, lanes[0].data() + lane)),
          hn::PromoteTo(to, hn::LoadU(from, lanes[1].data() + lane)),
          hn::PromoteTo(to, hn::LoadU(from, lanes[2].data() + lane))};
}

struct Box {
  Doubles::Vector centre, extent;
  std::array<Doubles::Vector, 3> axis;
};

HWY_INLINE Box box_of(const BoxLanes::Side& side, std::size_t lane) {
  const Doubles::Vector first = loaded(side.first, lane), second = loaded(side.second, lane);
  return {loaded(side.centre, lane), loaded(side.extent, lane), {first, second, Doubles::cross(first, second)}};
}

HWY_INLINE Doubles::Vector times(const Mat3& m, const Doubles::Vector& v) {
  return {Doubles::dot(Doubles::in_all(m[0]), v), Doubles::dot(Doubles::in_all(m[1]), v),
          Doubles::dot(Doubles::in_all(m[2]), v)};
}
HWY_INLINE Doubles::Vector transposed_times(const Mat3& m, const Doubles::Vector& v) {
  return {Doubles::dot(Doubles::in_all(m.column(0)), v), Doubles::dot(Doubles::in_all(m.column(1)), v),
          Doubles::dot(Doubles::in_all(m.column(2)), v)};
}

/// A box of the second tree, as seen from the first.
HWY_INLINE Box seen(const NearView& view, const Box& box) {
  using D = Doubles;
  const D::Number ratio = hn::Set(DoubleTag(), view.ratio);
  const D::Vector first = times(view.rotation, box.axis[0]), second = times(view.rotation, box.axis[1]);
  return {D::plus(D::in_all(view.offset), D::times(ratio, times(view.rotation, box.centre))),
          D::times(ratio, box.extent),
          {first, second, D::cross(first, second)}};
}

/// How far a box reaches from its centre in a direction.
HWY_INLINE Doubles::Number support(const Box& box, const Doubles::Vector& direction) {
  using D = Doubles;
  return hn::Add(hn::Add(hn::Mul(box.extent.x, hn::Abs(D::dot(box.axis[0], direction))),
                         hn::Mul(box.extent.y, hn::Abs(D::dot(box.axis[1], direction)))),
                 hn::Mul(box.extent.z, hn::Abs(D::dot(box.axis[2], direction))));
}

struct Way {
  Doubles::Vector direction;
  Doubles::Number squared;
};

/// From a box to the smallest one along its axes that holds the other, `between` being the way to the other's centre.
HWY_INLINE Way way_out_of(const Box& own, const Box& other, const Doubles::Vector& between) {
  using D = Doubles;
  const DoubleTag tag;
  const D::Number zero = hn::Zero(tag);
  const std::array<D::Number, 3> extent{own.extent.x, own.extent.y, own.extent.z};
  Way way{{zero, zero, zero}, zero};
  for (std::size_t i = 0; i < 3; ++i) {
    const D::Number along = D::dot(own.axis[i], between);
    const D::Number gap = hn::Max(hn::Sub(hn::Sub(hn::Abs(along), extent[i]), support(other, own.axis[i])), zero);
    way.squared = hn::Add(way.squared, hn::Mul(gap, gap));
    way.direction = D::plus(way.direction, D::times(hn::CopySign(gap, along), own.axis[i]));
  }
  return way;
}

/// The direction in which they seem to be farthest apart, of length 1; 0 where there is none.
HWY_INLINE Doubles::Vector parting_direction(const Box& own, const Box& other, const Doubles::Vector& between) {
  using D = Doubles;
  const DoubleTag tag;
  const Way by_own = way_out_of(own, other, between);
  const Way by_other = way_out_of(other, own, between);
  const D::Number squared = D::dot(between, between);
  const D::Number left =
      hn::Max(hn::Sub(hn::Sub(squared, support(own, between)), support(other, between)), hn::Zero(tag));
  const auto own_first = hn::Ge(by_own.squared, by_other.squared);
  const D::Number by_sides = hn::Max(by_own.squared, by_other.squared);
  const auto centres_first = hn::Gt(hn::Mul(left, left), hn::Mul(by_sides, squared));
  const D::Vector direction =
      D::chosen(centres_first, between, D::chosen(own_first, by_own.direction, by_other.direction));
  const D::Number length = hn::Sqrt(D::dot(direction, direction));
  const auto some = hn::Gt(length, hn::Zero(tag));
  return D::times(hn::IfThenElseZero(some, hn::Div(hn::Set(tag, 1), length)), direction);
}

HWY_INLINE Doubles::Number rounded(const Doubles::Number& value, float* to) {
  const hn::Rebind<float, DoubleTag> floats;
  const auto narrow = hn::DemoteTo(floats, value);
  hn::StoreU(narrow, floats, to);
  return hn::PromoteTo(DoubleTag(), narrow);
}
HWY_INLINE Doubles::Vector rounded(const Doubles::Vector& v, std::array<BoxLanes::Numbers, 3>& to, std::size_t lane) {
  return {rounded(v.x, to[0].data() + lane), rounded(v.y, to[1].data() + lane), rounded(v.z, to[2].data() + lane)};
}
/// Not below a number of at most some hundreds, computed in doubles.
HWY_INLINE Doubles::Number rounded_up(const Doubles::Number& value, float* to) {
  const DoubleTag tag;
  const Doubles::Number size = hn::Add(hn::Abs(value), hn::Set(tag, 1e-6));
  return rounded(hn::Add(value, hn::Mul(size, hn::Set(tag, 0x1p-22))), to);
}

void part_lanes(const NearView& view, const BoxLanes& boxes, GapPlaneLanes& planes) {
  using D = Doubles;
  const DoubleTag tag;
  for (std::size_t lane = 0; lane < GapPlaneLanes::width; lane += hn::Lanes(tag)) {
    const Box own = box_of(boxes.side[0], lane), local = box_of(boxes.side[1], lane), other = seen(view, local);
    const D::Vector between = D::minus(other.centre, own.centre);
    const D::Vector normal = rounded(parting_direction(own, other, between), planes.normal, lane);
    const D::Vector turned_now = D::times(hn::Set(tag, view.ratio), transposed_times(view.rotation, normal));
    const D::Vector turned = rounded(turned_now, planes.turned, lane), turn = D::minus(turned_now, turned);
    // The axes are orthonormal up to 2^-21.
    const D::Number size = hn::Mul(hn::Sqrt(D::dot(local.extent, local.extent)), hn::Set(tag, 1 + 0x1p-18));
    const D::Number radius = rounded_up(size, planes.radius.data() + lane);
    const D::Number reach =
        rounded_up(hn::Add(D::dot(normal, own.centre), hn::Add(support(own, normal), support(local, turned))),
                   planes.reach.data() + lane);
    const D::Number middle = hn::Add(D::dot(normal, D::in_all(view.offset)), D::dot(turned_now, local.centre));
    const D::Number swept = hn::Mul(hn::Sqrt(D::dot(turn, turn)), radius);
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
HWY_EXPORT(part_lanes);

constexpr float infinity = std::numeric_limits<float>::infinity();

void put_box(const NearTree& tree, std::uint32_t box, std::size_t lane, BoxLanes::Side& side) {
  const OrientedBlock& block = tree.blocks[box >> 3];
  const std::size_t from = box & 7U;
  for (std::size_t i = 0; i < 3; ++i) {
    side.centre[i][lane] = block.centre[i][from];
    side.first[i][lane] = block.axis[0][i][from];
    side.second[i][lane] = block.axis[1][i][from];
    side.extent[i][lane] = block.extent[i][from];
  }
}

void put_everywhere(const NearTree& tree, std::uint32_t box, BoxLanes::Side& side) {
  const OrientedBlock& block = tree.blocks[box >> 3];
  const std::size_t from = box & 7U;
  for (std::size_t i = 0; i < 3; ++i) {
    side.centre[i].fill(block.centre[i][from]);
    side.first[i].fill(block.axis[0][i][from]);
    side.second[i].fill(block.axis[1][i][from]);
    side.extent[i].fill(block.extent[i][from]);
  }
}

float up_to_float(double value) { return std::nextafter(static_cast<float>(value), infinity); }

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
    blocks_.back().reach.fill(-infinity);
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

void GapPlanes::unset(std::uint32_t place) { blocks_[place / width].reach[place % width] = -infinity; }

void GapPlanes::find_near(const NearView& view, double limit, std::vector<Near>& near) const {
  PlaneView floats{};
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
  BoxLanes boxes;
  for (std::size_t lane = 0; lane < GapPlaneLanes::width; ++lane) {
    const BoxPair& pair = pairs[lane < pairs.size() ? lane : 0];
    put_box(walk.tree(0), pair.first, lane, boxes.side[0]);
    put_box(walk.tree(1), pair.second, lane, boxes.side[1]);
  }
  planes.centre = boxes.side[1].centre;
  HWY_DYNAMIC_DISPATCH(part_lanes)(walk.view(0), boxes, planes);
}

void part_children(const NearWalk& walk, std::size_t side, std::uint32_t number, std::uint32_t other,
                   GapPlaneLanes& planes) {
  BoxLanes boxes;
  const OrientedBlock& block = walk.tree(side).blocks[number];
  boxes.side[side] = {block.centre, block.axis[0], block.axis[1], block.extent};
  put_everywhere(walk.tree(side ^ 1), other, boxes.side[side ^ 1]);
  planes.centre = boxes.side[1].centre;
  HWY_DYNAMIC_DISPATCH(part_lanes)(walk.view(0), boxes, planes);
}

}  // namespace toccata
#endif
