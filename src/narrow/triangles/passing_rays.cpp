// Compiled once for every SIMD level; Highway includes this file into itself.
#include "narrow/triangles/passing_rays.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/triangles/passing_rays.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "math/constants.hpp"
#include "narrow/triangles/one_lane.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

// The steps and bounds are those of ray_triangle.cpp, in the same order, so that the bits are the same.
constexpr double most_off_to_pass = 0x1p-43;

template <class N>
HWY_INLINE hn::Mask<TagOf<N>> is_middling(const N& size) {
  return hn::And(hn::Gt(size, all<N>(0x1p-200)), hn::Lt(size, all<N>(0x1p200)));
}

template <class V>
struct PassingTimes {
  NumberOf<V> lower, upper;
  MaskOf<V> told;
};

template <class V>
HWY_INLINE PassingTimes<V> passing_in_doubles(const V& motion, const NumberOf<V>& largest, const V& seen,
                                              const NumberOf<V>& seen_size, const V& normal, const NumberOf<V>& size) {
  using N = NumberOf<V>;
  const N bound = hn::Mul(hn::Mul(all<N>(64 * unit_roundoff), size), size), speed = dot(motion, normal);
  const N time = hn::Div(dot(seen, normal), speed), late = hn::Abs(time);
  const N sure_speed = hn::Sub(hn::Abs(speed), hn::Mul(bound, largest));
  const N off = hn::Add(hn::Div(hn::Mul(bound, hn::Add(seen_size, hn::Mul(late, largest))), sure_speed),
                        hn::Mul(all<N>(4 * unit_roundoff), late));
  const N lower = hn::Sub(time, off), upper = hn::Add(time, off);
  const auto known = hn::And(hn::And(is_middling(size), is_middling(seen_size)),
                             hn::And(is_middling(largest), hn::Gt(sure_speed, all<N>(0))));
  const auto settled =
      hn::And(hn::Le(off, all<N>(most_off_to_pass)), hn::And(hn::Gt(lower, all<N>(0)), hn::Lt(upper, all<N>(1))));
  return {lower, upper, hn::And(known, settled)};
}

template <class V>
HWY_INLINE V scaled_to_unit(const V& normal) {
  const V scaled = each([](const auto& x, const auto& largest) HWY_ATTR { return hn::Div(x, largest); }, normal,
                        in_each(normal, greatest_of(normal)));
  return times(hn::Div(all<NumberOf<V>>(1), hn::Sqrt(dot(scaled, scaled))), scaled);
}

/// Rays, and the corners of their triangles.
template <class V>
struct Passing {
  V origin, motion, first, second, third;
  NumberOf<V> largest;
};

/// PassingHit, of each.
template <class V>
struct Passed {
  V point, normal;
  NumberOf<V> lower, upper;
  MaskOf<V> told;
};

template <class V>
HWY_INLINE Passed<V> passed(const Passing<V>& asked) {
  using N = NumberOf<V>;
  const V a = minus(asked.first, asked.origin), b = minus(asked.second, asked.origin),
          c = minus(asked.third, asked.origin);
  const N seen_size = greater(greater(greatest_of(a), greatest_of(b)), greatest_of(c));
  const V e = minus(asked.second, asked.first), f = minus(asked.third, asked.first), normal = cross(e, f);
  const N size = greater(greatest_of(e), greatest_of(f));
  const PassingTimes<V> passing = passing_in_doubles(asked.motion, asked.largest, a, seen_size, normal, size);
  const auto cancels = hn::Lt(dot(normal, normal), hn::Mul(all<N>(0x1p-40), hn::Mul(dot(e, e), dot(f, f))));
  const V outwards = scaled_to_unit(normal);
  const auto away = hn::Gt(dot(outwards, asked.motion), all<N>(0));
  const N time = hn::Mul(all<N>(0.5), hn::Add(passing.lower, passing.upper));
  return {plus(asked.origin, times(time, asked.motion)), select(away, negative(outwards), outwards), passing.lower,
          passing.upper, hn::AndNot(cancels, passing.told)};
}

HWY_INLINE Vec3 first_of(const OneVector& v) { return {first_of(x_of(v)), first_of(y_of(v)), first_of(z_of(v))}; }

PassingHit run_one_passing(const PassingRay& one) {
  // Number by number: they were mostly written just now, and a load of several at once would wait for that.
  const auto fresh = [](const Vec3& v) HWY_ATTR { return in_one(v.x, v.y, v.z); };
  const Triangle& target = one.target;
  const Passed<OneVector> found =
      passed<OneVector>({fresh(one.ray->origin), fresh(one.ray->motion), fresh(target[0]), fresh(target[1]),
                         fresh(target[2]), all<OneNumber>(one.ray->largest)});
  PassingHit hit;
  hit.told = hn::AllTrue(OneTag(), found.told);
  if (!hit.told) return hit;
  hit.cast.lower = first_of(found.lower);
  hit.cast.upper = first_of(found.upper);
  hit.cast.point = first_of(found.point);
  hit.cast.normal = first_of(found.normal);
  return hit;
}

/// So many rays and triangles, or answers, number by number.
struct PassingRows {
  HWY_INLINE void put(std::size_t first, std::size_t lane, const Vec3& v) {
    row[first][lane] = v.x;
    row[first + 1][lane] = v.y;
    row[first + 2][lane] = v.z;
  }
  HWY_INLINE Vec3 vector(std::size_t first, std::size_t lane) const {
    return {row[first][lane], row[first + 1][lane], row[first + 2][lane]};
  }
  HWY_INLINE Vector load(std::size_t first) const {
    return {hn::Load(tag, row[first]), hn::Load(tag, row[first + 1]), hn::Load(tag, row[first + 2])};
  }
  HWY_INLINE void store(std::size_t first, const Vector& v) {
    hn::Store(v.x, tag, row[first]);
    hn::Store(v.y, tag, row[first + 1]);
    hn::Store(v.z, tag, row[first + 2]);
  }
  alignas(64) double row[16][most_lanes];
};

/// Rows of origin, motion, the three corners and the greatest coordinate of the motion, to rows of point, normal, lower
/// and upper time, and 1 where they are told.
void answer(const PassingRows& asked, PassingRows& answers) {
  const Passed<Vector> found = passed<Vector>(
      {asked.load(0), asked.load(3), asked.load(6), asked.load(9), asked.load(12), hn::Load(tag, asked.row[15])});
  answers.store(0, found.point);
  answers.store(3, found.normal);
  hn::Store(found.lower, tag, answers.row[6]);
  hn::Store(found.upper, tag, answers.row[7]);
  hn::Store(hn::IfThenElseZero(found.told, all(1)), tag, answers.row[8]);
}

void put(const PassingRay& one, PassingRows& rows, std::size_t lane) {
  rows.put(0, lane, one.ray->origin);
  rows.put(3, lane, one.ray->motion);
  for (int i = 0; i < 3; ++i) rows.put(6 + 3 * static_cast<std::size_t>(i), lane, one.target[i]);
  rows.row[15][lane] = one.ray->largest;
}

void take(const PassingRows& rows, std::size_t lane, PassingHit& hit) {
  hit.told = rows.row[8][lane] != 0;
  if (!hit.told) return;
  hit.cast.lower = rows.row[6][lane];
  hit.cast.upper = rows.row[7][lane];
  hit.cast.point = rows.vector(0, lane);
  hit.cast.normal = rows.vector(3, lane);
}

void run_passing(std::span<const PassingRay> rays, std::span<PassingHit> hits) {
  const std::size_t lanes = hn::Lanes(tag);
  PassingRows asked, answers;
  for (std::size_t first = 0; first < rays.size(); first += lanes) {
    const std::size_t count = std::min(lanes, rays.size() - first);
    // Lanes that are left over do what the last ray does.
    for (std::size_t lane = 0; lane < lanes; ++lane) put(rays[first + std::min(lane, count - 1)], asked, lane);
    answer(asked, answers);
    for (std::size_t lane = 0; lane < count; ++lane) take(answers, lane, hits[first + lane]);
  }
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(run_one_passing);
HWY_EXPORT(run_passing);

}  // namespace

PassingHit hit_of_passing(const PassingRay& passing) { return HWY_DYNAMIC_DISPATCH(run_one_passing)(passing); }

void hits_of_passing(std::span<const PassingRay> rays, std::span<PassingHit> hits) {
  HWY_DYNAMIC_DISPATCH(run_passing)(rays, hits);
}

}  // namespace toccata
#endif
