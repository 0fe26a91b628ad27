// How far the triangles of a block are from a point, all at once, in floats. Included once for every SIMD level, so its
// guard toggles with Highway's instead of letting it in only once.
#if defined(TOCCATA_TREES_POINT_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_TREES_POINT_LANES_HPP
#undef TOCCATA_TREES_POINT_LANES_HPP
#else
#define TOCCATA_TREES_POINT_LANES_HPP
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>

#include "trees/leaf_triangles.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

namespace lane_floats {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, WideBlock::width>;
using Float = hn::Vec<Floats>;

// a < b ? a : b and a > b ? a : b, which is what one instruction of x86 does.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
HWY_INLINE Float lesser(const Float& a, const Float& b) { return hn::Min(a, b); }
HWY_INLINE Float greater(const Float& a, const Float& b) { return hn::Max(a, b); }
#else
HWY_INLINE Float lesser(const Float& a, const Float& b) { return hn::IfThenElse(hn::Lt(a, b), a, b); }
HWY_INLINE Float greater(const Float& a, const Float& b) { return hn::IfThenElse(hn::Gt(a, b), a, b); }
#endif

/// NaN becomes 0.
HWY_INLINE Float share_up_to(const Float& most, const Float& value) {
  return lesser(greater(value, hn::Zero(Floats())), most);
}

struct Vector {
  Float x, y, z;
};

HWY_INLINE Vector plus(const Vector& u, const Vector& v) {
  return {hn::Add(u.x, v.x), hn::Add(u.y, v.y), hn::Add(u.z, v.z)};
}
HWY_INLINE Vector minus(const Vector& u, const Vector& v) {
  return {hn::Sub(u.x, v.x), hn::Sub(u.y, v.y), hn::Sub(u.z, v.z)};
}
HWY_INLINE Vector times(const Float& s, const Vector& v) { return {hn::Mul(s, v.x), hn::Mul(s, v.y), hn::Mul(s, v.z)}; }
HWY_INLINE Float dot(const Vector& u, const Vector& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}
HWY_INLINE Float greatest_of(const Vector& v) { return greater(greater(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z)); }

HWY_INLINE Vector corner(const TriangleLanes& triangles, std::size_t i, std::size_t first) {
  const Floats d;
  return {hn::Load(d, triangles.corner[i][0].data() + first), hn::Load(d, triangles.corner[i][1].data() + first),
          hn::Load(d, triangles.corner[i][2].data() + first)};
}

/// The least of some differences from a point to points of a triangle.
struct Least {
  Vector difference;
  Float squared;

  HWY_INLINE void see(const Vector& other) {
    const Float other_squared = dot(other, other);
    const auto less = hn::Lt(other_squared, squared);
    difference = {hn::IfThenElse(less, other.x, difference.x), hn::IfThenElse(less, other.y, difference.y),
                  hn::IfThenElse(less, other.z, difference.z)};
    squared = lesser(other_squared, squared);
  }
};

/// Seen from the point: the foot on the face where it has one, and the nearest points of the edges. Shares are within 0
/// and 1 whatever rounding does, so all are points of the triangle.
HWY_INLINE Least least_difference(const Vector& a, const Vector& b, const Vector& c) {
  const Float one = hn::Set(Floats(), 1.0F);
  const Vector ab = minus(b, a), ac = minus(c, a), bc = minus(c, b);
  const Float along_ab = hn::Neg(dot(ab, a)), along_ac = hn::Neg(dot(ac, a)), along_bc = hn::Neg(dot(bc, b));
  const Float ab_squared = dot(ab, ab), ac_squared = dot(ac, ac), both = dot(ab, ac);
  const Vector on_ab = plus(a, times(share_up_to(one, hn::Div(along_ab, ab_squared)), ab));
  Least least{on_ab, dot(on_ab, on_ab)};
  least.see(plus(a, times(share_up_to(one, hn::Div(along_ac, ac_squared)), ac)));
  least.see(plus(b, times(share_up_to(one, hn::Div(along_bc, dot(bc, bc))), bc)));
  const Float inverse = hn::Div(one, hn::Sub(hn::Mul(ab_squared, ac_squared), hn::Mul(both, both)));
  const Float s = share_up_to(one, hn::Mul(hn::Sub(hn::Mul(along_ab, ac_squared), hn::Mul(along_ac, both)), inverse));
  const Float t =
      share_up_to(hn::Sub(one, s), hn::Mul(hn::Sub(hn::Mul(along_ac, ab_squared), hn::Mul(along_ab, both)), inverse));
  least.see(plus(a, plus(times(s, ab), times(t, ac))));
  return least;
}

struct LaneBounds {
  Float lower, upper;
};

/// Of the triangles from lane `first` on: docs/methods/nearest-point.md. `pad` is at least 2⁻³⁰ and what the floats
/// given are off by; no coordinate is above 2³⁰.
HWY_INLINE LaneBounds bounds_of(const TriangleLanes& triangles, std::size_t first, const std::array<float, 3>& point,
                                float pad) {
  const Floats tag;
  const Vector p{hn::Set(tag, point[0]), hn::Set(tag, point[1]), hn::Set(tag, point[2])};
  const Vector a = minus(corner(triangles, 0, first), p), b = minus(corner(triangles, 1, first), p),
               c = minus(corner(triangles, 2, first), p);
  const Least least = least_difference(a, b, c);
  const Vector& d = least.difference;
  const Float length = hn::Sqrt(least.squared), height = lesser(lesser(dot(a, d), dot(b, d)), dot(c, d));
  const Float size = greater(greater(greatest_of(a), greatest_of(b)), greatest_of(c));
  const Float off = hn::Add(hn::Mul(hn::Set(tag, 0x1p-19F), size), hn::Set(tag, pad));
  const Float lower = greater(hn::Sub(hn::Div(height, length), off), hn::Zero(tag));
  return {hn::IfThenElseZero(hn::Gt(length, off), lower), hn::Add(length, off)};
}

}  // namespace lane_floats

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
