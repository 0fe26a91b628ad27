// Distances of cores grown by radii, from their near points: docs/design/primitive-distances.md.
// Included once for every SIMD level (lanes.hpp).
#if defined(TOCCATA_NARROW_GROWN_CORES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_GROWN_CORES_HPP
#undef TOCCATA_NARROW_GROWN_CORES_HPP
#else
#define TOCCATA_NARROW_GROWN_CORES_HPP
#endif

#include <limits>

#include "narrow/triangles/near_points.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// Of the interval to the upper end: less than 10⁻¹².
constexpr double most_relative_width = 0.99e-12;

/// Two cores grown by their radii.
struct Reached {
  Number lower, upper;
  Number inverse;  ///< 1 / |d|
  Number reach;    ///< the sum of the radii
  Mask apart;      ///< the distance is certainly in the interval, which is narrow
  Mask meets;      ///< certainly
};

/// What is summed up in `error`, in ε: the spread of d along itself; 2.5 for the root, and 1 for what near points that
/// are not the nearest lose; 1 for the sum of the radii; 2 for the differences. Its floor is more than is lost to
/// underflow, and keeps the interval of distances below 2^-250 from being narrow; above 2^248 is another limit: between
/// these no square over- or underflows. The root and the division do not wait for each other.
HWY_INLINE Reached reached(const NearPoints& near, const Number& radius_a, const Number& radius_b) {
  const Number length = hn::Sqrt(near.squared),
               inverse_squared = hn::Div(all(1), hn::Add(near.squared, all(0x1p-1000)));
  const Number reach = hn::Add(radius_a, radius_b), gap = hn::Sub(length, reach);
  const Number inverse = hn::Mul(length, inverse_squared);
  const Number parts = hn::Add(hn::Add(hn::Mul(near.spread, inverse), hn::Mul(all(4), length)),
                               hn::Add(reach, hn::Mul(all(2), hn::Abs(gap))));
  const Number error = hn::Add(hn::Mul(all(0x1.01p-53), parts), all(0x1p-290));
  const Number upper = hn::Add(gap, error), lower = hn::Sub(gap, hn::Add(error, hn::Mul(near.loss, inverse)));
  const Mask plain = hn::And(near.placed, hn::Lt(parts, all(0x1p248)));
  const Mask narrow = hn::Le(hn::Sub(upper, lower), hn::Mul(all(most_relative_width), lower));
  return {lower,
          upper,
          inverse,
          reach,
          hn::And(plain, hn::And(near.tight, narrow)),
          hn::And(plain, hn::Lt(hn::Add(upper, near.slack), hn::Zero(Tag())))};
}

struct Ends {
  Vector on_a, on_b;
};

/// Of cores that are apart.
HWY_INLINE Ends ends_of(const NearPoints& near, const Reached& reached, const Number& radius_a,
                        const Number& radius_b) {
  return {minus(near.on_a, times(hn::Mul(radius_a, reached.inverse), near.apart)),
          plus(near.on_b, times(hn::Mul(radius_b, reached.inverse), near.apart))};
}

/// Of cores that meet: it divides the way as the radii do.
HWY_INLINE Vector common_point(const NearPoints& near, const Reached& reached, const Number& radius_a) {
  return minus(near.on_a, times(hn::Div(radius_a, reached.reach), near.apart));
}

struct Found {
  Number lower, upper;  ///< NaN where nothing is proved
  Vector on_a, on_b;
};

HWY_INLINE Found found_of(const Reached& reached, const Ends& ends, const Vector& common) {
  const Number zero = hn::Zero(Tag()), none = all(std::numeric_limits<double>::quiet_NaN());
  const auto number = [&](const Number& value) {
    return hn::IfThenElse(reached.meets, zero, hn::IfThenElse(reached.apart, value, none));
  };
  return {number(reached.lower), number(reached.upper), select(reached.meets, common, ends.on_a),
          select(reached.meets, common, ends.on_b)};
}

HWY_INLINE Found grown(const NearPoints& near, const Number& radius_a, const Number& radius_b) {
  const Reached how = reached(near, radius_a, radius_b);
  return found_of(how, ends_of(near, how, radius_a, radius_b), common_point(near, how, radius_a));
}

HWY_INLINE Mask is_zero(const Number& x) { return hn::Eq(x, hn::Zero(Tag())); }
HWY_INLINE Mask is_positive(const Number& x) { return hn::Gt(x, hn::Zero(Tag())); }

/// p comes after q in lexicographic order.
HWY_INLINE Mask comes_after(const Vector& p, const Vector& q) {
  const Vector d = minus(p, q);
  const Mask by_last = hn::Or(is_positive(y_of(d)), hn::And(is_zero(y_of(d)), is_positive(z_of(d))));
  return hn::Or(is_positive(x_of(d)), hn::And(is_zero(x_of(d)), by_last));
}

HWY_INLINE Found exchanged(const Mask& mask, const Found& found) {
  return {found.lower, found.upper, select(mask, found.on_b, found.on_a), select(mask, found.on_a, found.on_b)};
}

struct Ball {
  Vector centre;
  Number radius;
};

struct Rod {
  Vector start, end;
  Number radius;
};

HWY_INLINE Rod chosen(const Mask& mask, const Rod& yes, const Rod& no) {
  return {select(mask, yes.start, no.start), select(mask, yes.end, no.end),
          hn::IfThenElse(mask, yes.radius, no.radius)};
}

// Without a branch: no processor foresees which is the first.

/// Exchanging them exchanges all but the common point, which is seen from the first in lexicographic order.
HWY_INLINE Found found_of(const Ball& a, const Ball& b) {
  const NearPoints near = near_of_points(a.centre, b.centre), other_way = near_of_points(b.centre, a.centre);
  const Reached how = reached(near, a.radius, b.radius);
  const Vector common = select(comes_after(a.centre, b.centre), common_point(other_way, how, b.radius),
                               common_point(near, how, a.radius));
  return found_of(how, ends_of(near, how, a.radius, b.radius), common);
}

/// They go through the formula in their lexicographic order.
HWY_INLINE Found found_of(const Rod& a, const Rod& b) {
  const Mask exchange = comes_after(a.start, b.start);
  const Rod first = chosen(exchange, b, a), second = chosen(exchange, a, b);
  Found found = grown(near_of_segments(first.start, first.end, second.start, second.end), first.radius, second.radius);
  const Vector d = minus(a.start, b.start);
  const Mask same_start = hn::And(is_zero(x_of(d)), hn::And(is_zero(y_of(d)), is_zero(z_of(d))));
  found.upper = hn::IfThenElse(same_start, all(std::numeric_limits<double>::quiet_NaN()), found.upper);
  return exchanged(exchange, found);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
