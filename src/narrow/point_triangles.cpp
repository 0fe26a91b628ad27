// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/point_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "narrow/grown_cores.hpp"
#include "narrow/point_triangles.hpp"

#ifndef TOCCATA_NARROW_POINT_TRIANGLES_ONCE
#define TOCCATA_NARROW_POINT_TRIANGLES_ONCE
namespace toccata {

// What the levels share. It is defined here, before any level's instructions are switched on.
inline const double* lanes_at(const TriangleBlock& block, std::size_t corner, std::size_t axis) {
  return block.corner[corner][axis].data();
}

}  // namespace toccata
#endif

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE Vector corner(const TriangleBlock& block, std::size_t i, std::size_t lane) {
  return {hn::Load(Tag(), lanes_at(block, i, 0) + lane), hn::Load(Tag(), lanes_at(block, i, 1) + lane),
          hn::Load(Tag(), lanes_at(block, i, 2) + lane)};
}

/// The least height of the corners along any vector d bounds the distance from below: (v − p) · d / |d|, each off by
/// less than 10 ε of the sum of magnitudes, of which 16 ε are taken off. 0 where squares may leave the range of
/// doubles.
HWY_INLINE Number lower_by_heights(const Vector& p, const std::array<Vector, 3>& v, const NearPoints& near) {
  Number least = all(0), size = all(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector from = minus(p, v[i]);
    const Number height = dot(from, near.apart);
    least = i == 0 ? height : lesser(least, height);
    size = i == 0 ? sum_of(magnitudes_of(from)) : greater(size, sum_of(magnitudes_of(from)));
  }
  const Number off = hn::Mul(all(0x1p-49), size), zero = hn::Zero(Tag());
  const Mask plain =
      hn::And(hn::And(hn::Gt(near.squared, all(0x1p-500)), is_moderate(near.squared)), hn::Lt(size, all(0x1p250)));
  return hn::IfThenElseZero(plain, greater(hn::Sub(hn::Div(least, hn::Sqrt(near.squared)), off), zero));
}

HWY_INLINE void measure_lanes(const Vector& p, const TriangleBlock& triangles, std::size_t lane,
                              PointDistances& distances) {
  const std::array<Vector, 3> v{corner(triangles, 0, lane), corner(triangles, 1, lane), corner(triangles, 2, lane)};
  const NearPoints near = near_of_point_triangle(p, v[0], v[1], v[2]);
  const Number zero = hn::Zero(Tag());
  const Reached how = reached(near, zero, zero);
  const Found found = found_of(how, {near.on_a, near.on_b}, near.on_a);
  hn::Store(found.upper, Tag(), distances.upper.data() + lane);
  hn::Store(lower_by_heights(p, v, near), Tag(), distances.lower.data() + lane);
  hn::Store(found.on_b.x, Tag(), distances.nearest[0].data() + lane);
  hn::Store(found.on_b.y, Tag(), distances.nearest[1].data() + lane);
  hn::Store(found.on_b.z, Tag(), distances.nearest[2].data() + lane);
}

}  // namespace

void measure_at_this_level(const Vec3& point, const TriangleBlock& triangles, PointDistances& distances) {
  const Vector p = lanes_of(point);
  for (std::size_t lane = 0; lane < TriangleBlock::lanes; lane += hn::Lanes(Tag()))
    measure_lanes(p, triangles, lane, distances);
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(measure_at_this_level);

void measure(const Vec3& point, const TriangleBlock& triangles, PointDistances& distances) {
  HWY_DYNAMIC_DISPATCH(measure_at_this_level)(point, triangles, distances);
}

}  // namespace toccata
#endif
