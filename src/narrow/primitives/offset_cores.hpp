// Distances of cores grown by radii, from their near points: docs/design/primitive-distances.md.
// The formulas are for vectors V, one in each lane, with numbers N and masks M: of many pairs, or of one
// (one_lane.hpp). Included once for every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_NARROW_OFFSET_CORES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_OFFSET_CORES_HPP
#undef TOCCATA_NARROW_OFFSET_CORES_HPP
#else
#define TOCCATA_NARROW_OFFSET_CORES_HPP
#endif

#include <limits>

#include "narrow/primitives/near_points.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// The most that the width of an interval may be of its upper end: less than 10⁻¹².
constexpr double most_relative_width = 0.99e-12;

/// Two cores grown by their radii.
template <class V>
struct Reached {
  NumberOf<V> lower, upper;
  NumberOf<V> inverse;  ///< 1 / |d|
  NumberOf<V> reach;    ///< the sum of the radii
  MaskOf<V> apart;      ///< the distance is certainly in the interval, which is narrow
  MaskOf<V> meets;      ///< certainly
};

/// What is summed up in `error`, in ε: the spread of d along itself; 2.5 for the root, and 1 for what near points that
/// are not the nearest lose; 1 for the sum of the radii; 2 for the differences. Its floor is more than is lost to
/// underflow, and keeps the interval of distances below 2^-250 from being narrow; above 2^248 is another limit: between
/// these no square over- or underflows. The root and the division do not wait for each other.
template <class V>
HWY_INLINE Reached<V> reached(const NearPoints<V>& near, const NumberOf<V>& radius_a, const NumberOf<V>& radius_b) {
  using N = NumberOf<V>;
  using M = MaskOf<V>;
  const N length = hn::Sqrt(near.squared),
          inverse_squared = hn::Div(all<N>(1), hn::Add(near.squared, all<N>(0x1p-1000)));
  const N reach = hn::Add(radius_a, radius_b), gap = hn::Sub(length, reach);
  const N inverse = hn::Mul(length, inverse_squared);
  const N parts = hn::Add(hn::Add(hn::Mul(near.spread, inverse), hn::Mul(all<N>(4), length)),
                          hn::Add(reach, hn::Mul(all<N>(2), hn::Abs(gap))));
  const N error = hn::Add(hn::Mul(all<N>(0x1.01p-53), parts), all<N>(0x1p-290));
  const N upper = hn::Add(gap, error), lower = hn::Sub(gap, hn::Add(error, hn::Mul(near.loss, inverse)));
  const M plain = hn::And(near.placed, hn::Lt(parts, all<N>(0x1p248)));
  const M narrow = hn::Le(hn::Sub(upper, lower), hn::Mul(all<N>(most_relative_width), lower));
  return {lower,
          upper,
          inverse,
          reach,
          hn::And(plain, hn::And(near.tight, narrow)),
          hn::And(plain, hn::Lt(hn::Add(upper, near.slack), hn::Zero(TagOf<N>())))};
}

template <class V>
struct ReachedEnds {
  V on_a, on_b;
};

/// The ends of the way between shapes whose cores are apart.
template <class V>
HWY_INLINE ReachedEnds<V> ends_of(const NearPoints<V>& near, const Reached<V>& reached, const NumberOf<V>& radius_a,
                                  const NumberOf<V>& radius_b) {
  return {minus(near.on_a, times(hn::Mul(radius_a, reached.inverse), near.apart)),
          plus(near.on_b, times(hn::Mul(radius_b, reached.inverse), near.apart))};
}

/// A common point of shapes that meet: it divides the way between the cores as the radii do.
template <class V>
HWY_INLINE V common_point(const NearPoints<V>& near, const Reached<V>& reached, const NumberOf<V>& radius_a) {
  return minus(near.on_a, times(hn::Div(radius_a, reached.reach), near.apart));
}

template <class V>
struct Found {
  NumberOf<V> lower, upper;  ///< NaN where nothing is proved
  V on_a, on_b;
};

template <class V>
HWY_INLINE Found<V> found_of(const Reached<V>& reached, const ReachedEnds<V>& ends, const V& common) {
  using N = NumberOf<V>;
  const N zero = hn::Zero(TagOf<N>()), none = all<N>(std::numeric_limits<double>::quiet_NaN());
  const auto number = [&](const N& value) {
    return hn::IfThenElse(reached.meets, zero, hn::IfThenElse(reached.apart, value, none));
  };
  return {number(reached.lower), number(reached.upper), select(reached.meets, common, ends.on_a),
          select(reached.meets, common, ends.on_b)};
}

template <class V>
HWY_INLINE Found<V> offset_outward(const NearPoints<V>& near, const NumberOf<V>& radius_a,
                                   const NumberOf<V>& radius_b) {
  const Reached<V> how = reached(near, radius_a, radius_b);
  return found_of(how, ends_of(near, how, radius_a, radius_b), common_point(near, how, radius_a));
}

template <class N>
HWY_INLINE auto is_zero(const N& x) {
  return hn::Eq(x, hn::Zero(TagOf<N>()));
}
template <class N>
HWY_INLINE auto is_positive(const N& x) {
  return hn::Gt(x, hn::Zero(TagOf<N>()));
}

/// p comes after q in lexicographic order.
template <class V>
HWY_INLINE MaskOf<V> comes_after(const V& p, const V& q) {
  using M = MaskOf<V>;
  const V d = minus(p, q);
  const M by_last = hn::Or(is_positive(y_of(d)), hn::And(is_zero(y_of(d)), is_positive(z_of(d))));
  return hn::Or(is_positive(x_of(d)), hn::And(is_zero(x_of(d)), by_last));
}

template <class V>
HWY_INLINE Found<V> exchanged(const MaskOf<V>& mask, const Found<V>& found) {
  return {found.lower, found.upper, select(mask, found.on_b, found.on_a), select(mask, found.on_a, found.on_b)};
}

template <class V>
struct OffsetPoint {
  V centre;
  NumberOf<V> radius;
};

template <class V>
struct OffsetSegment {
  V start, end;
  NumberOf<V> radius;
};

template <class V>
HWY_INLINE OffsetSegment<V> chosen(const MaskOf<V>& mask, const OffsetSegment<V>& yes, const OffsetSegment<V>& no) {
  return {select(mask, yes.start, no.start), select(mask, yes.end, no.end),
          hn::IfThenElse(mask, yes.radius, no.radius)};
}

// Without a branch: no processor foresees which is the first.

/// Exchanging them exchanges all but the common point, which is seen from the first in lexicographic order.
template <class V>
HWY_INLINE Found<V> found_of(const OffsetPoint<V>& a, const OffsetPoint<V>& b) {
  const NearPoints<V> near = near_of_points(a.centre, b.centre), other_way = near_of_points(b.centre, a.centre);
  const Reached<V> how = reached(near, a.radius, b.radius);
  const V common = select(comes_after(a.centre, b.centre), common_point(other_way, how, b.radius),
                          common_point(near, how, a.radius));
  return found_of(how, ends_of(near, how, a.radius, b.radius), common);
}

/// They go through the formula in their lexicographic order.
template <class V>
HWY_INLINE Found<V> found_of(const OffsetSegment<V>& a, const OffsetSegment<V>& b) {
  using N = NumberOf<V>;
  using M = MaskOf<V>;
  const M exchange = comes_after(a.start, b.start);
  const OffsetSegment<V> first = chosen(exchange, b, a), second = chosen(exchange, a, b);
  Found<V> found =
      offset_outward(near_of_segments(first.start, first.end, second.start, second.end), first.radius, second.radius);
  const V d = minus(a.start, b.start);
  const M same_start = hn::And(is_zero(x_of(d)), hn::And(is_zero(y_of(d)), is_zero(z_of(d))));
  found.upper = hn::IfThenElse(same_start, all<N>(std::numeric_limits<double>::quiet_NaN()), found.upper);
  return exchanged(exchange, found);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
