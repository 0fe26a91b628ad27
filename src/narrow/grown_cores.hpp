// Distances of cores grown by radii, from their near points: docs/design/primitive-distances.md.
// Included once for every SIMD level (lanes.hpp).
#if defined(TOCCATA_NARROW_GROWN_CORES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_GROWN_CORES_HPP
#undef TOCCATA_NARROW_GROWN_CORES_HPP
#else
#define TOCCATA_NARROW_GROWN_CORES_HPP
#endif

#include <limits>

#include "narrow/near_points.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

struct Found {
  Number lower, upper;  ///< NaN where nothing is proved
  Vector on_a, on_b;
};

/// Of the interval to the upper end: less than 10⁻¹².
constexpr double most_relative_width = 0.99e-12;

/// Two cores grown by their radii. What is summed up in `error`, in ε: the spread of d along itself; 2.5 for the root,
/// and 1 for what near points that are not the nearest lose; 1 for the sum of the radii; 2 for the differences.
HWY_INLINE Found grown(const NearPoints& near, const Number& radius_a, const Number& radius_b) {
  const Number zero = hn::Zero(Tag());
  const Number length = hn::Sqrt(near.squared), reach = hn::Add(radius_a, radius_b), gap = hn::Sub(length, reach);
  const Number inverse = hn::Div(all(1), hn::Add(length, all(0x1p-480)));
  const Number parts = hn::Add(hn::Add(hn::Mul(near.spread, inverse), hn::Mul(all(4), length)),
                               hn::Add(reach, hn::Mul(all(2), hn::Abs(gap))));
  const Number error = hn::Add(hn::Mul(all(0x1.01p-53), parts), all(0x1p-480));
  const Number loss = hn::Mul(near.loss, inverse);
  const Mask plain = hn::And(near.placed, hn::And(is_moderate(near.squared), is_moderate(reach)));
  const Mask meets = hn::And(plain, hn::Lt(hn::Add(hn::Add(gap, error), near.slack), zero));
  const Number lower = hn::Sub(gap, hn::Add(error, loss)), upper = hn::Add(gap, error);
  const Mask narrow = hn::Le(hn::Sub(upper, lower), hn::Mul(all(most_relative_width), lower));
  const Mask far_enough = hn::And(hn::Gt(near.squared, all(1 / greatest_square)), hn::Gt(lower, zero));
  const Mask apart = hn::And(hn::And(plain, near.tight), hn::And(narrow, far_enough));

  const Number share = hn::Div(radius_a, hn::IfThenElse(meets, reach, length));
  const Vector on_a = minus(near.on_a, times(share, near.apart));
  const Vector on_b = plus(near.on_b, times(hn::Mul(radius_b, inverse), near.apart));
  const Number none = all(std::numeric_limits<double>::quiet_NaN());
  const auto number = [&](const Number& value) {
    return hn::IfThenElse(meets, zero, hn::IfThenElse(apart, value, none));
  };
  return {number(lower), number(upper), on_a, select(meets, on_a, on_b)};
}

HWY_INLINE Mask is_zero(const Number& x) { return hn::Eq(x, hn::Zero(Tag())); }
HWY_INLINE Mask is_positive(const Number& x) { return hn::Gt(x, hn::Zero(Tag())); }

/// p comes after q in lexicographic order.
HWY_INLINE Mask comes_after(const Vector& p, const Vector& q) {
  const Vector d = minus(p, q);
  const Mask by_last = hn::Or(is_positive(d.y), hn::And(is_zero(d.y), is_positive(d.z)));
  return hn::Or(is_positive(d.x), hn::And(is_zero(d.x), by_last));
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

HWY_INLINE Ball chosen(const Mask& mask, const Ball& yes, const Ball& no) {
  return {select(mask, yes.centre, no.centre), hn::IfThenElse(mask, yes.radius, no.radius)};
}

HWY_INLINE Rod chosen(const Mask& mask, const Rod& yes, const Rod& no) {
  return {select(mask, yes.start, no.start), select(mask, yes.end, no.end),
          hn::IfThenElse(mask, yes.radius, no.radius)};
}

// Two of a kind go through the formula in their lexicographic order. Without a branch: no processor foresees it.

HWY_INLINE Found found_of(const Ball& a, const Ball& b) {
  const Mask exchange = comes_after(a.centre, b.centre);
  const Ball first = chosen(exchange, b, a), second = chosen(exchange, a, b);
  return exchanged(exchange, grown(near_of_points(first.centre, second.centre), first.radius, second.radius));
}

HWY_INLINE Found found_of(const Rod& a, const Rod& b) {
  const Mask exchange = comes_after(a.start, b.start);
  const Rod first = chosen(exchange, b, a), second = chosen(exchange, a, b);
  Found found = grown(near_of_segments(first.start, first.end, second.start, second.end), first.radius, second.radius);
  const Vector d = minus(a.start, b.start);
  const Mask same_start = hn::And(is_zero(d.x), hn::And(is_zero(d.y), is_zero(d.z)));
  found.upper = hn::IfThenElse(same_start, all(std::numeric_limits<double>::quiet_NaN()), found.upper);
  return exchanged(exchange, found);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
