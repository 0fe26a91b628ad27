// How far the turned boxes of a block are from a box of another tree, all at once. Included once for every SIMD level,
// so its guard toggles with Highway's instead of letting it in only once.
#if defined(TOCCATA_TREES_BOX_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_TREES_BOX_LANES_HPP
#undef TOCCATA_TREES_BOX_LANES_HPP
#else
#define TOCCATA_TREES_BOX_LANES_HPP
#endif

#include <array>
#include <cmath>
#include <cstddef>

#include "math/lanes.hpp"
#include "trees/near_walk.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

static_assert(OrientedBlock::width == most_lanes);

using BlockBounds = std::array<double, most_lanes>;

HWY_INLINE Number loaded(const std::array<float, most_lanes>& values, std::size_t lane) {
  return hn::PromoteTo(tag, hn::LoadU(hn::Rebind<float, Tag>(), values.data() + lane));
}
HWY_INLINE Vector loaded(const std::array<std::array<float, most_lanes>, 3>& values, std::size_t lane) {
  return {loaded(values[0], lane), loaded(values[1], lane), loaded(values[2], lane)};
}
HWY_INLINE Number sum_of_products(const std::array<Number, 3>& u, const std::array<Number, 3>& v) {
  return hn::Add(hn::Add(hn::Mul(u[0], v[0]), hn::Mul(u[1], v[1])), hn::Mul(u[2], v[2]));
}

HWY_INLINE Vec3 vector_of(const std::array<std::array<float, most_lanes>, 3>& values, std::size_t lane) {
  return {values[0][lane], values[1][lane], values[2][lane]};
}
HWY_INLINE Vec3 turned(const Mat3& m, const Vec3& v) {
  return {toccata::dot(m[0], v), toccata::dot(m[1], v), toccata::dot(m[2], v)};
}

/// The boxes of a block of the other tree in the own frame.
struct alignas(64) SeenBlock {
  using Lanes = std::array<double, most_lanes>;
  std::array<Lanes, 3> centre, extent;
  std::array<std::array<Lanes, 3>, 3> axis;
};

HWY_INLINE Vector turned(const Mat3& m, const Vector& v) {
  return {dot(in_all(m[0]), v), dot(in_all(m[1]), v), dot(in_all(m[2]), v)};
}
HWY_INLINE void store(const Vector& v, std::array<SeenBlock::Lanes, 3>& to, std::size_t lane) {
  hn::StoreU(v.x, tag, to[0].data() + lane);
  hn::StoreU(v.y, tag, to[1].data() + lane);
  hn::StoreU(v.z, tag, to[2].data() + lane);
}

HWY_INLINE void see(const NearView& view, const OrientedBlock& block, SeenBlock& seen) {
  const Mat3& turn = view.rigid ? view.rotation : view.other;
  const Number ratio = all(view.rigid ? view.ratio : 1);
  for (std::size_t lane = 0; lane < most_lanes; lane += hn::Lanes(tag)) {
    const Vector first = loaded(block.axis[0], lane), second = loaded(block.axis[1], lane);
    const Vector one = turned(turn, first), other = turned(turn, second);
    store(plus(in_all(view.offset), times(ratio, turned(turn, loaded(block.centre, lane)))), seen.centre, lane);
    store(times(ratio, loaded(block.extent, lane)), seen.extent, lane);
    store(one, seen.axis[0], lane);
    store(other, seen.axis[1], lane);
    store(view.rigid ? cross(one, other) : turned(turn, cross(first, second)), seen.axis[2], lane);
  }
}

HWY_INLINE Vec3 vector_of(const std::array<SeenBlock::Lanes, 3>& values, std::size_t lane) {
  return {values[0][lane], values[1][lane], values[2][lane]};
}

/// One of them.
struct Seen {
  Vec3 centre;
  std::array<Vec3, 3> axis;
  Vec3 extent;
  double size;
};

HWY_INLINE Seen seen_in(const SeenBlock& block, std::size_t lane) {
  const Vec3 extent = vector_of(block.extent, lane);
  return {vector_of(block.centre, lane),
          {vector_of(block.axis[0], lane), vector_of(block.axis[1], lane), vector_of(block.axis[2], lane)},
          extent,
          (extent.x + extent.y) + extent.z};
}

/// The square of how far apart two boxes are along an axis of one, or 0; `along` is how far their centres are, and
/// `cosine` what the other's axes share with it, in magnitude.
HWY_INLINE Number squared_gap(const Number& along, const Number& extent, const std::array<Number, 3>& other_extent,
                              const std::array<Number, 3>& cosine) {
  const Number gap = hn::Sub(hn::Sub(along, extent), sum_of_products(other_extent, cosine));
  const Number part = greater(gap, hn::Zero(tag));
  return hn::Mul(part, part);
}

HWY_INLINE std::array<Number, 3> magnitudes_along(const std::array<Vector, 3>& axes, const Vector& v) {
  return {hn::Abs(dot(axes[0], v)), hn::Abs(dot(axes[1], v)), hn::Abs(dot(axes[2], v))};
}

/// Never above the distance of two boxes (docs/methods/mesh-distance.md): the gaps along the own axes, those along the
/// other's, and the gap along the line of the centres, whichever is largest. Without loops, which would keep what is
/// found in memory.
HWY_INLINE Number bound_of_rigid(const NearView& view, const OrientedBlock& block, std::size_t lane, const Seen& box) {
  using Three = std::array<Number, 3>;
  const Vector first = loaded(block.axis[0], lane), second = loaded(block.axis[1], lane);
  const std::array<Vector, 3> own{first, second, cross(first, second)};
  const std::array<Vector, 3> other{in_all(box.axis[0]), in_all(box.axis[1]), in_all(box.axis[2])};
  const Three extent{loaded(block.extent[0], lane), loaded(block.extent[1], lane), loaded(block.extent[2], lane)};
  const Three other_extent{all(box.extent.x), all(box.extent.y), all(box.extent.z)};
  const Vector between = minus(in_all(box.centre), loaded(block.centre, lane));

  const Three along_own = magnitudes_along(own, between), along_other = magnitudes_along(other, between);
  const Three c0 = magnitudes_along(other, own[0]), c1 = magnitudes_along(other, own[1]),
              c2 = magnitudes_along(other, own[2]);
  const Number by_own = hn::Add(hn::Add(squared_gap(along_own[0], extent[0], other_extent, c0),
                                        squared_gap(along_own[1], extent[1], other_extent, c1)),
                                squared_gap(along_own[2], extent[2], other_extent, c2));
  const Number by_other = hn::Add(hn::Add(squared_gap(along_other[0], other_extent[0], extent, {c0[0], c1[0], c2[0]}),
                                          squared_gap(along_other[1], other_extent[1], extent, {c0[1], c1[1], c2[1]})),
                                  squared_gap(along_other[2], other_extent[2], extent, {c0[2], c1[2], c2[2]}));
  const Number zero = hn::Zero(tag);
  const Number by_sides = hn::Mul(greater(by_own, by_other), all(1 - 0x1p-18));
  const Number squared = dot(between, between);
  const Number reach = hn::Add(sum_of_products(extent, along_own), sum_of_products(other_extent, along_other));
  const Number left = greater(hn::Sub(squared, reach), zero);
  // Not left² / squared: a fourth power of lengths leaves the range of doubles where distances are far from it.
  const Number by_centres = hn::Mul(left, hn::Div(left, squared));
  return hn::Mul(hn::Sub(hn::Sqrt(greater(by_centres, by_sides)), all(view.pad)), all(view.scale));
}

/// The same under any poses: along the line of the centres alone.
HWY_INLINE double bound_of_any(const NearView& view, const OrientedBlock& block, std::size_t lane, const Seen& box) {
  const Vec3 between = box.centre - turned(view.own, vector_of(block.centre, lane));
  const Vec3 first = vector_of(block.axis[0], lane), second = vector_of(block.axis[1], lane);
  const std::array<Vec3, 3> axis{first, second, toccata::cross(first, second)};
  double reach = 0;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    reach += block.extent[at][lane] * std::fabs(toccata::dot(between, turned(view.own, axis[at])));
    reach += box.extent[i] * std::fabs(toccata::dot(between, box.axis[at]));
  }
  const double squared = toccata::dot(between, between), left = squared - reach;
  return left > 0 ? (left / std::sqrt(squared) - view.pad) * view.scale : 0 * view.scale;
}

HWY_INLINE void bounds_of(const NearView& view, const OrientedBlock& block, const Seen& box, BlockBounds& bounds) {
  if (view.rigid)
    for (std::size_t lane = 0; lane < most_lanes; lane += hn::Lanes(tag))
      hn::StoreU(bound_of_rigid(view, block, lane, box), tag, bounds.data() + lane);
  else
    for (std::size_t lane = 0; lane < most_lanes; ++lane) bounds[lane] = bound_of_any(view, block, lane, box);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
