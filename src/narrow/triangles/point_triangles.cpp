// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/triangles/point_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "narrow/primitives/offset_cores.hpp"
#include "narrow/triangles/least_difference.hpp"
#include "narrow/triangles/point_triangles.hpp"
#include "narrow/triangles/triangle_gap_rounding.hpp"

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
  return {hn::Load(tag, lanes_at(block, i, 0) + lane), hn::Load(tag, lanes_at(block, i, 1) + lane),
          hn::Load(tag, lanes_at(block, i, 2) + lane)};
}

/// The least height of the corners along any vector d bounds the distance from below: (v − p) · d / |d|, each off by
/// less than 10 ε of the sum of magnitudes, of which 16 ε are taken off. 0 where squares may leave the range of
/// doubles.
HWY_INLINE Number lower_by_heights(const Vector& p, const std::array<Vector, 3>& v, const NearPoints<Vector>& near) {
  Number least = all(0), size = all(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector from = minus(p, v[i]);
    const Number height = dot(from, near.apart);
    least = i == 0 ? height : lesser(least, height);
    size = i == 0 ? sum_of(magnitudes_of(from)) : greater(size, sum_of(magnitudes_of(from)));
  }
  const Number off = hn::Mul(all(0x1p-49), size), zero = hn::Zero(tag);
  const Mask plain =
      hn::And(hn::And(hn::Gt(near.squared, all(0x1p-500)), is_moderate(near.squared)), hn::Lt(size, all(0x1p250)));
  return hn::IfThenElseZero(plain, greater(hn::Sub(hn::Div(least, hn::Sqrt(near.squared)), off), zero));
}

HWY_INLINE void measure_lanes(const Vector& p, const TriangleBlock& triangles, std::size_t lane,
                              PointDistances& distances) {
  const std::array<Vector, 3> v{corner(triangles, 0, lane), corner(triangles, 1, lane), corner(triangles, 2, lane)};
  const NearPoints<Vector> near = near_of_point_triangle(p, v[0], v[1], v[2]);
  const Number zero = hn::Zero(tag);
  const Reached<Vector> how = reached(near, zero, zero);
  const Found<Vector> found = found_of(how, {near.on_a, near.on_b}, near.on_a);
  hn::Store(found.upper, tag, distances.upper.data() + lane);
  hn::Store(lower_by_heights(p, v, near), tag, distances.lower.data() + lane);
  hn::Store(found.on_b.x, tag, distances.nearest[0].data() + lane);
  hn::Store(found.on_b.y, tag, distances.nearest[1].data() + lane);
  hn::Store(found.on_b.z, tag, distances.nearest[2].data() + lane);
}

/// The formula of `transform`, bit by bit.
HWY_INLINE Number row_times(const Vec3& row, const Vector& v, double offset) {
  const Number sum = hn::Add(hn::Add(hn::Mul(all(row.x), v.x), hn::Mul(all(row.y), v.y)), hn::Mul(all(row.z), v.z));
  return hn::Add(sum, all(offset));
}
HWY_INLINE Vector in_world(const Pose& pose, const Vector& v) {
  const Mat3& r = pose.linear;
  return {row_times(r[0], v, pose.offset.x), row_times(r[1], v, pose.offset.y), row_times(r[2], v, pose.offset.z)};
}

/// The bounds are those of two triangles, one of which is a point: docs/methods/mesh-distance.md.
HWY_INLINE void bound_lanes(const Vector& p, const Pose& pose, const TriangleBlock& triangles, std::size_t lane,
                            PointBounds& bounds) {
  const Vector a = minus(in_world(pose, corner(triangles, 0, lane)), p),
               b = minus(in_world(pose, corner(triangles, 1, lane)), p),
               c = minus(in_world(pose, corner(triangles, 2, lane)), p);
  const LeastDifference<Vector> least = least_difference(a, b, c);
  const Vector& d = least.difference;
  const Number length = hn::Sqrt(least.squared), height = lesser(lesser(dot(a, d), dot(b, d)), dot(c, d));
  const Number size = greater(greater(greatest_of(a), greatest_of(b)), greatest_of(c));
  const Number off = hn::Mul(all(triangle_gap_rounding), size), zero = hn::Zero(tag);
  const Mask plain = hn::And(hn::Gt(size, all(0x1p-200)), hn::Lt(size, all(0x1p200)));
  const Mask some = hn::And(plain, hn::Gt(length, off));
  hn::Store(hn::IfThenElseZero(some, greater(hn::Sub(hn::Div(height, length), off), zero)), tag,
            bounds.lower.data() + lane);
  hn::Store(hn::IfThenElse(plain, hn::Add(length, off), hn::Inf(tag)), tag, bounds.upper.data() + lane);
}

}  // namespace

void bound_at_this_level(const Vec3& point, const Pose& pose, const TriangleBlock& triangles, PointBounds& bounds) {
  const Vector p = in_all(point);
  for (std::size_t lane = 0; lane < triangles.count; lane += hn::Lanes(tag))
    bound_lanes(p, pose, triangles, lane, bounds);
}

void measure_at_this_level(const Vec3& point, const TriangleBlock& triangles, PointDistances& distances) {
  const Vector p = in_all(point);
  for (std::size_t lane = 0; lane < triangles.count; lane += hn::Lanes(tag))
    measure_lanes(p, triangles, lane, distances);
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(bound_at_this_level);
HWY_EXPORT(measure_at_this_level);

void bound(const Vec3& point, const Pose& pose, const TriangleBlock& triangles, PointBounds& bounds) {
  HWY_DYNAMIC_DISPATCH(bound_at_this_level)(point, pose, triangles, bounds);
}

void measure(const Vec3& point, const TriangleBlock& triangles, PointDistances& distances) {
  HWY_DYNAMIC_DISPATCH(measure_at_this_level)(point, triangles, distances);
}

}  // namespace toccata
#endif
