// The least difference from a point to a triangle, in each lane. Included once for every SIMD level, like
// math/lanes.hpp.
#if defined(TOCCATA_NARROW_LEAST_DIFFERENCE_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_LEAST_DIFFERENCE_HPP
#undef TOCCATA_NARROW_LEAST_DIFFERENCE_HPP
#else
#define TOCCATA_NARROW_LEAST_DIFFERENCE_HPP
#endif

#include "math/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// The least of some differences from a point to points of a triangle.
template <class V>
struct LeastDifference {
  V difference;
  NumberOf<V> squared;

  HWY_INLINE void see(const V& other) {
    const NumberOf<V> other_squared = dot(other, other);
    difference = select(hn::Lt(other_squared, squared), other, difference);
    squared = lesser(other_squared, squared);
  }
};

/// Seen from the point: the foot on the face where it has one, and the nearest points of the edges. Shares are within 0
/// and 1 whatever rounding does, so all are points of the triangle.
template <class V>
HWY_INLINE LeastDifference<V> least_difference(const V& a, const V& b, const V& c) {
  using N = NumberOf<V>;
  const V ab = minus(b, a), ac = minus(c, a), bc = minus(c, b);
  const N along_ab = hn::Neg(dot(ab, a)), along_ac = hn::Neg(dot(ac, a)), along_bc = hn::Neg(dot(bc, b));
  const N ab_squared = dot(ab, ab), ac_squared = dot(ac, ac), both = dot(ab, ac);
  const V on_ab = plus(a, times(clamped_share(hn::Div(along_ab, ab_squared)), ab));
  LeastDifference<V> least{on_ab, dot(on_ab, on_ab)};
  least.see(plus(a, times(clamped_share(hn::Div(along_ac, ac_squared)), ac)));
  least.see(plus(b, times(clamped_share(hn::Div(along_bc, dot(bc, bc))), bc)));
  const N inverse = hn::Div(all<N>(1), hn::Sub(hn::Mul(ab_squared, ac_squared), hn::Mul(both, both)));
  const N s = clamped_share(hn::Mul(hn::Sub(hn::Mul(along_ab, ac_squared), hn::Mul(along_ac, both)), inverse));
  const N t = clamped_between(hn::Mul(hn::Sub(hn::Mul(along_ac, ab_squared), hn::Mul(along_ab, both)), inverse),
                              hn::Zero(TagOf<N>()), hn::Sub(all<N>(1), s));
  least.see(plus(a, plus(times(s, ab), times(t, ac))));
  return least;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
