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
#include <type_traits>

#include "narrow/triangles/one_lane.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

// Products may be fused here.

template <class T>
HWY_INLINE LaneVector<T> product(const Mat3& m, const LaneVector<T>& v) {
  const auto row_times = [&](const Vec3& row) HWY_ATTR {
    return hn::MulAdd(hn::Set(T(), row.x), v.x,
                      hn::MulAdd(hn::Set(T(), row.y), v.y, hn::Mul(hn::Set(T(), row.z), v.z)));
  };
  return {row_times(m[0]), row_times(m[1]), row_times(m[2])};
}
#if HWY_TARGET <= HWY_AVX2
HWY_INLINE OneVector product(const Mat3& m, const OneVector& v) {
  const auto column = [&](int i) HWY_ATTR { return in_one(m[0][i], m[1][i], m[2][i]); };
  const auto fused = [](const auto& s, const auto& c, const auto& sum) HWY_ATTR { return hn::MulAdd(s, c, sum); };
  return each(fused, in_each(v, x_of(v)), column(0),
              each(fused, in_each(v, y_of(v)), column(1), times(z_of(v), column(2))));
}
#endif

/// The part of the way within a box.
template <class V>
struct PartOfWay {
  NumberOf<V> from, to;
};

template <class V>
HWY_INLINE PartOfWay<V> part_within(const Aabb& box, const NumberOf<V>& around, const V& origin, const V& motion) {
  using N = NumberOf<V>;
  // What moves less far than `least` is told by where it is; `around` allows for it.
  [[maybe_unused]] constexpr double slack = 0x1p-50, least = 0x1p-900;
  const V near = in_each(origin, around);
  const V low = minus(minus(in_lanes_of(origin, box.lower), near), origin);
  const V high = minus(plus(in_lanes_of(origin, box.upper), near), origin);
  // Less, where rounding may have made it too much along one axis. A ray that stands still along the axis, or nearly
  // so, is within for ever, or never.
  const V from = each(
      [](const auto& l, const auto& h, const auto& m) HWY_ATTR {
        using C = std::remove_cvref_t<decltype(m)>;
        const C inverse = hn::Div(all<C>(1), m), zero = hn::Zero(TagOf<C>());
        const C enter = hn::Min(hn::Mul(l, inverse), hn::Mul(h, inverse));
        const C never = hn::IfThenElseZero(hn::Or(hn::Gt(l, zero), hn::Lt(h, zero)), all<C>(2));
        return hn::IfThenElse(hn::Lt(hn::Abs(m), all<C>(least)), never,
                              hn::Sub(enter, hn::Mul(all<C>(slack), hn::Abs(enter))));
      },
      low, high, motion);
  const V to = each(
      [](const auto& l, const auto& h, const auto& m) HWY_ATTR {
        using C = std::remove_cvref_t<decltype(m)>;
        const C inverse = hn::Div(all<C>(1), m);
        const C leave = hn::Max(hn::Mul(l, inverse), hn::Mul(h, inverse));
        return hn::IfThenElse(hn::Lt(hn::Abs(m), all<C>(least)), all<C>(1),
                              hn::Add(leave, hn::Mul(all<C>(slack), hn::Abs(leave))));
      },
      low, high, motion);
  return {hn::Max(hn::Max(x_of(from), y_of(from)), hn::Max(z_of(from), all<N>(0))),
          hn::Min(hn::Min(x_of(to), y_of(to)), hn::Min(z_of(to), all<N>(1)))};
}

/// RayInTree, of each.
template <class V>
struct Brought {
  V origin, motion;
  NumberOf<V> pad, lean, late, from, to;
  MaskOf<V> known;
};

template <class V>
HWY_INLINE Brought<V> brought(const RayFrame& frame, const V& from, const V& along, const NumberOf<V>& largest) {
  using N = NumberOf<V>;
  constexpr double longest = 0x1p46, most_off = 1, most_off_for_triangles = 0x1p-5;
  const V motion = product(frame.back, along);
  const V apart = minus(from, in_lanes_of(from, frame.offset));
  const V origin = minus(product(frame.back, apart), in_lanes_of(from, frame.origin));
  const N size = hn::Add(greatest_of(from), largest), speed = greatest_of(motion);
  const N off = hn::MulAdd(all<N>(frame.off_by_size), size, all<N>(frame.off));
  const PartOfWay<V> part = part_within(frame.box, hn::Add(off, all<N>(0x1p-40)), origin, motion);

  const N length = hn::Sub(part.to, part.from), far = all<N>(HUGE_VAL);
  const auto near = hn::Lt(off, all<N>(frame.has_units ? most_off_for_triangles : -1));
  const N lean = hn::Div(hn::Mul(all<N>(frame.off_by_size * (1 + 0x1p-20)), largest), speed);
  Brought<V> result;
  result.known =
      hn::And(hn::And(hn::Lt(speed, all<N>(longest)), hn::Lt(off, all<N>(most_off))), hn::Lt(greatest_of(apart), far));
  result.from = part.from;
  result.to = part.to;
  result.origin = plus(origin, times(part.from, motion));
  result.motion = times(length, motion);
  // Floats, and the doubles here, round less than 2^-20 of what is at most 8, and 2^-50 of what cancels.
  result.pad = hn::Add(hn::Add(off, all<N>(0x1p-20)), hn::Mul(all<N>(0x1p-50), hn::Add(greatest_of(origin), speed)));
  result.lean = hn::IfThenElse(near, hn::Add(lean, all<N>(0x1p-40)), far);
  // As wide as a time may be told to be.
  result.late = hn::IfThenElse(hn::Gt(length, all<N>(0x1p-60)), hn::Div(all<N>(0x1p-40), length), far);
  return result;
}

HWY_INLINE float float_of(const OneNumber& value) { return static_cast<float>(hn::GetLane(value)); }

RayInTree run_ray_into_tree(const RayFrame& frame, const PreparedRay& ray) {
  // Number by number: they were mostly written just now, and a load of several at once would wait for that.
  const auto fresh = [](const Vec3& v) HWY_ATTR { return in_one(v.x, v.y, v.z); };
  const auto found = brought(frame, fresh(ray.origin), fresh(ray.motion), all<OneNumber>(ray.largest));
  RayInTree one;
  one.ray.origin = {float_of(x_of(found.origin)), float_of(y_of(found.origin)), float_of(z_of(found.origin))};
  one.ray.motion = {float_of(x_of(found.motion)), float_of(y_of(found.motion)), float_of(z_of(found.motion))};
  one.ray.pad = float_of(found.pad);
  one.ray.lean = float_of(found.lean);
  one.ray.late = float_of(found.late);
  one.from = first_of(found.from);
  one.to = first_of(found.to);
  one.known = hn::AllTrue(OneTag(), found.known);
  return one;
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

HWY_INLINE void store(const Vector& v, std::array<LaneDoubles, 3>& rows) {
  hn::Store(v.x, tag, rows[0].data());
  hn::Store(v.y, tag, rows[1].data());
  hn::Store(v.z, tag, rows[2].data());
}

/// As many rays as there are lanes.
void bring(const RayFrame& frame, const RayRows& rows, ResultRows& result) {
  const Brought<Vector> found =
      brought(frame, load(rows.origin), load(rows.motion), hn::Load(tag, rows.largest.data()));
  store(found.origin, result.origin);
  store(found.motion, result.motion);
  hn::Store(found.pad, tag, result.pad.data());
  hn::Store(found.lean, tag, result.lean.data());
  hn::Store(found.late, tag, result.late.data());
  hn::Store(found.from, tag, result.from.data());
  hn::Store(found.to, tag, result.to.data());
  hn::Store(hn::IfThenElseZero(found.known, all(1)), tag, result.known.data());
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

HWY_EXPORT(run_ray_into_tree);
HWY_EXPORT(run_rays_into_tree);

}  // namespace

RayInTree ray_into_tree(const RayFrame& frame, const PreparedRay& ray) {
  return HWY_DYNAMIC_DISPATCH(run_ray_into_tree)(frame, ray);
}

void rays_into_tree(const RayFrame& frame, std::span<const PreparedRay> rays, std::span<RayInTree> result) {
  HWY_DYNAMIC_DISPATCH(run_rays_into_tree)(frame, rays, result);
}

}  // namespace toccata
#endif
