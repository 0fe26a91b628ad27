// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/rays_into_tree.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trees/rays_into_tree.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "math/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

// Products may be fused here.

HWY_INLINE Number greatest_coordinate_of(const Vector& v) {
  return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}
HWY_INLINE Number row_times(const Vec3& row, const Vector& v) {
  return hn::MulAdd(all(row.x), v.x, hn::MulAdd(all(row.y), v.y, hn::Mul(all(row.z), v.z)));
}
HWY_INLINE Vector product(const Mat3& m, const Vector& v) {
  return {row_times(m[0], v), row_times(m[1], v), row_times(m[2], v)};
}

/// A few rays, number by number.
using LaneDoubles = std::array<double, most_lanes>;
struct RayRows {
  alignas(64) std::array<LaneDoubles, 3> origin, motion;
  alignas(64) LaneDoubles largest;
};
struct ResultRows {
  alignas(64) std::array<LaneDoubles, 3> origin, motion;
  alignas(64) LaneDoubles pad, lean, late, from, to, known;
};

HWY_INLINE Vector load(const std::array<LaneDoubles, 3>& rows) {
  return {hn::Load(tag, rows[0].data()), hn::Load(tag, rows[1].data()), hn::Load(tag, rows[2].data())};
}

struct PartOfWay {
  Number from, to;
};

/// Less, where rounding may have made it too much along one axis.
HWY_INLINE void cut(PartOfWay& part, double lower, double upper, const Number& around, const Number& origin,
                    const Number& motion) {
  // What moves less far than `least` is told by where it is; `around` allows for it.
  constexpr double slack = 0x1p-50, least = 0x1p-900;
  const Number zero = hn::Zero(tag);
  const Number low = hn::Sub(hn::Sub(all(lower), around), origin), high = hn::Sub(hn::Add(all(upper), around), origin);
  const Number inverse = hn::Div(all(1), motion), s = hn::Mul(low, inverse), t = hn::Mul(high, inverse);
  const Number enter = hn::Min(s, t), leave = hn::Max(s, t);
  // A ray that stands still along the axis, or nearly so, is within for ever, or never.
  const auto still = hn::Lt(hn::Abs(motion), all(least));
  const Number never = hn::IfThenElseZero(hn::Or(hn::Gt(low, zero), hn::Lt(high, zero)), all(2));
  const Number from = hn::Sub(enter, hn::Mul(all(slack), hn::Abs(enter)));
  const Number to = hn::Add(leave, hn::Mul(all(slack), hn::Abs(leave)));
  part.from = hn::Max(hn::IfThenElse(still, never, from), part.from);
  part.to = hn::Min(hn::IfThenElse(still, all(1), to), part.to);
}

HWY_INLINE void store(const Vector& v, std::array<LaneDoubles, 3>& rows) {
  hn::Store(v.x, tag, rows[0].data());
  hn::Store(v.y, tag, rows[1].data());
  hn::Store(v.z, tag, rows[2].data());
}

/// As many rays as there are lanes.
void bring(const RayFrame& frame, const RayRows& rows, ResultRows& result) {
  constexpr double longest = 0x1p46, most_off = 1, most_off_for_triangles = 0x1p-5;
  const Vector from = load(rows.origin), along = load(rows.motion);
  const Number largest = hn::Load(tag, rows.largest.data());
  const Vector motion = product(frame.back, along);
  const Vector apart = minus(from, in_all(frame.offset));
  const Vector origin = minus(product(frame.back, apart), in_all(frame.origin));
  const Number size = hn::Add(greatest_coordinate_of(from), largest), speed = greatest_coordinate_of(motion);
  const Number off = hn::MulAdd(all(frame.off_by_size), size, all(frame.off));

  PartOfWay part{hn::Zero(tag), all(1)};
  const Number around = hn::Add(off, all(0x1p-40));
  cut(part, frame.box.lower.x, frame.box.upper.x, around, origin.x, motion.x);
  cut(part, frame.box.lower.y, frame.box.upper.y, around, origin.y, motion.y);
  cut(part, frame.box.lower.z, frame.box.upper.z, around, origin.z, motion.z);

  const Number length = hn::Sub(part.to, part.from), far = all(HUGE_VAL);
  const auto known = hn::And(hn::And(hn::Lt(speed, all(longest)), hn::Lt(off, all(most_off))),
                             hn::Lt(greatest_coordinate_of(apart), far));
  const auto near = hn::Lt(off, all(frame.has_units ? most_off_for_triangles : -1));
  const Number lean = hn::Div(hn::Mul(all(frame.off_by_size * (1 + 0x1p-20)), largest), speed);
  // As wide as a time may be told to be.
  const Number late = hn::IfThenElse(hn::Gt(length, all(0x1p-60)), hn::Div(all(0x1p-40), length), far);
  // Floats, and the doubles here, round less than 2^-20 of what is at most 8, and 2^-50 of what cancels.
  const Number pad =
      hn::Add(hn::Add(off, all(0x1p-20)), hn::Mul(all(0x1p-50), hn::Add(greatest_coordinate_of(origin), speed)));
  store({hn::MulAdd(part.from, motion.x, origin.x), hn::MulAdd(part.from, motion.y, origin.y),
         hn::MulAdd(part.from, motion.z, origin.z)},
        result.origin);
  store({hn::Mul(length, motion.x), hn::Mul(length, motion.y), hn::Mul(length, motion.z)}, result.motion);
  hn::Store(pad, tag, result.pad.data());
  hn::Store(hn::IfThenElse(near, hn::Add(lean, all(0x1p-40)), far), tag, result.lean.data());
  hn::Store(late, tag, result.late.data());
  hn::Store(part.from, tag, result.from.data());
  hn::Store(part.to, tag, result.to.data());
  hn::Store(hn::IfThenElseZero(known, all(1)), tag, result.known.data());
}

void put(const PreparedRay& ray, RayRows& rows, std::size_t lane) {
  for (int axis = 0; axis < 3; ++axis) {
    rows.origin[static_cast<std::size_t>(axis)][lane] = ray.origin[axis];
    rows.motion[static_cast<std::size_t>(axis)][lane] = ray.motion[axis];
  }
  rows.largest[lane] = ray.largest;
}

void take(const ResultRows& rows, std::size_t lane, RayInTree& one) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    one.ray.origin[axis] = static_cast<float>(rows.origin[axis][lane]);
    one.ray.motion[axis] = static_cast<float>(rows.motion[axis][lane]);
  }
  one.ray.pad = static_cast<float>(rows.pad[lane]);
  one.ray.lean = static_cast<float>(rows.lean[lane]);
  one.ray.late = static_cast<float>(rows.late[lane]);
  one.from = rows.from[lane];
  one.to = rows.to[lane];
  one.known = rows.known[lane] != 0;
}

void run_rays_into_tree(const RayFrame& frame, std::span<const PreparedRay> rays, std::span<RayInTree> result) {
  const std::size_t lanes = hn::Lanes(tag);
  RayRows rows;
  ResultRows found;
  for (std::size_t first = 0; first < rays.size(); first += lanes) {
    const std::size_t count = std::min(lanes, rays.size() - first);
    // Lanes that are left over do what the last ray does.
    for (std::size_t lane = 0; lane < lanes; ++lane) put(rays[first + std::min(lane, count - 1)], rows, lane);
    bring(frame, rows, found);
    for (std::size_t lane = 0; lane < count; ++lane) take(found, lane, result[first + lane]);
  }
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(run_rays_into_tree);

}  // namespace

void rays_into_tree(const RayFrame& frame, std::span<const PreparedRay> rays, std::span<RayInTree> result) {
  HWY_DYNAMIC_DISPATCH(run_rays_into_tree)(frame, rays, result);
}

}  // namespace toccata
#endif
