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
#include "math/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

// The steps and bounds are those of ray_triangle.cpp, in the same order, so that the bits are the same.
constexpr double most_off_to_pass = 0x1p-43;

HWY_INLINE Mask is_middling(const Number& size) {
  return hn::And(hn::Gt(size, all(0x1p-200)), hn::Lt(size, all(0x1p200)));
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

struct PassingTimes {
  Number lower, upper;
  Mask told;
};

HWY_INLINE PassingTimes passing_in_doubles(const Vector& motion, const Number& largest, const Vector& seen,
                                           const Number& seen_size, const Vector& normal, const Number& size) {
  const Number bound = hn::Mul(hn::Mul(all(64 * unit_roundoff), size), size), speed = dot(motion, normal);
  const Number time = hn::Div(dot(seen, normal), speed), late = hn::Abs(time);
  const Number sure_speed = hn::Sub(hn::Abs(speed), hn::Mul(bound, largest));
  const Number off = hn::Add(hn::Div(hn::Mul(bound, hn::Add(seen_size, hn::Mul(late, largest))), sure_speed),
                             hn::Mul(all(4 * unit_roundoff), late));
  const Number lower = hn::Sub(time, off), upper = hn::Add(time, off);
  const Mask known = hn::And(hn::And(is_middling(size), is_middling(seen_size)),
                             hn::And(is_middling(largest), hn::Gt(sure_speed, hn::Zero(tag))));
  const Mask settled =
      hn::And(hn::Le(off, all(most_off_to_pass)), hn::And(hn::Gt(lower, hn::Zero(tag)), hn::Lt(upper, all(1))));
  return {lower, upper, hn::And(known, settled)};
}

HWY_INLINE Vector scaled_to_unit(const Vector& normal) {
  const Number largest = greatest_of(normal);
  const Vector scaled{hn::Div(normal.x, largest), hn::Div(normal.y, largest), hn::Div(normal.z, largest)};
  return times(hn::Div(all(1), hn::Sqrt(dot(scaled, scaled))), scaled);
}

/// Rows of origin, motion, the three corners and the greatest coordinate of the motion, to rows of point, normal, lower
/// and upper time, and 1 where they are told.
void answer(const PassingRows& asked, PassingRows& answers) {
  const Vector origin = asked.load(0), motion = asked.load(3);
  const Vector first = asked.load(6), second = asked.load(9), third = asked.load(12);
  const Number largest = hn::Load(tag, asked.row[15]);
  const Vector a = minus(first, origin), b = minus(second, origin), c = minus(third, origin);
  const Number seen_size = greater(greater(greatest_of(a), greatest_of(b)), greatest_of(c));
  const Vector e = minus(second, first), f = minus(third, first), normal = cross(e, f);
  const Number size = greater(greatest_of(e), greatest_of(f));
  const PassingTimes passing = passing_in_doubles(motion, largest, a, seen_size, normal, size);
  const Mask cancels = hn::Lt(dot(normal, normal), hn::Mul(all(0x1p-40), hn::Mul(dot(e, e), dot(f, f))));
  const Vector outwards = scaled_to_unit(normal);
  const Mask away = hn::Gt(dot(outwards, motion), hn::Zero(tag));
  const Number time = hn::Mul(all(0.5), hn::Add(passing.lower, passing.upper));
  answers.store(0, plus(origin, times(time, motion)));
  answers.store(3, select(away, negative(outwards), outwards));
  hn::Store(passing.lower, tag, answers.row[6]);
  hn::Store(passing.upper, tag, answers.row[7]);
  hn::Store(hn::IfThenElseZero(hn::AndNot(cancels, passing.told), all(1)), tag, answers.row[8]);
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
  hit.cast.hit = true;
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

HWY_EXPORT(run_passing);

}  // namespace

void hits_of_passing(std::span<const PassingRay> rays, std::span<PassingHit> hits) {
  HWY_DYNAMIC_DISPATCH(run_passing)(rays, hits);
}

}  // namespace toccata
#endif
