// How far the triangles of a block are from a point, all at once, in floats. Included once for every SIMD level, so its
// guard toggles with Highway's instead of letting it in only once.
#if defined(TOCCATA_TREES_POINT_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_TREES_POINT_LANES_HPP
#undef TOCCATA_TREES_POINT_LANES_HPP
#else
#define TOCCATA_TREES_POINT_LANES_HPP
#endif

#include <array>
#include <cstddef>

#include "narrow/triangles/least_difference.hpp"
#include "trees/block_lanes.hpp"
#include "trees/leaf_triangles.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE FloatVector corner(const TriangleLanes& triangles, std::size_t i, std::size_t first) {
  const Floats d;
  return {hn::Load(d, triangles.corner[i][0].data() + first), hn::Load(d, triangles.corner[i][1].data() + first),
          hn::Load(d, triangles.corner[i][2].data() + first)};
}

struct FloatBounds {
  Float lower, upper;
};

/// Bounds for the triangles from lane `first` on: docs/methods/nearest-point.md. `pad` is at least 2⁻³⁰ and what the
/// floats given are off by; no coordinate is above 2³⁰.
HWY_INLINE FloatBounds bounds_of(const TriangleLanes& triangles, std::size_t first, const std::array<float, 3>& point,
                                 float pad) {
  constexpr Floats floats;
  const FloatVector p = in_all(floats, point);
  const FloatVector a = minus(corner(triangles, 0, first), p), b = minus(corner(triangles, 1, first), p),
                    c = minus(corner(triangles, 2, first), p);
  const LeastDifference<FloatVector> least = least_difference(a, b, c);
  const FloatVector& d = least.difference;
  const Float length = hn::Sqrt(least.squared), height = lesser(lesser(dot(a, d), dot(b, d)), dot(c, d));
  const Float size = greater(greater(greatest_of(a), greatest_of(b)), greatest_of(c));
  const Float off = hn::Add(hn::Mul(hn::Set(floats, 0x1p-19F), size), hn::Set(floats, pad));
  const Float lower = greater(hn::Sub(hn::Div(height, length), off), hn::Zero(floats));
  return {hn::IfThenElseZero(hn::Gt(length, off), lower), hn::Add(length, off)};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
