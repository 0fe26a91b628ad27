// Vectors with coordinates of twice the digits, and lengths. Included once for every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_NARROW_LONG_VECTOR_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_LONG_VECTOR_HPP
#undef TOCCATA_NARROW_LONG_VECTOR_HPP
#else
#define TOCCATA_NARROW_LONG_VECTOR_HPP
#endif

#include "math/exact_products.hpp"
#include "narrow/triangles/one_lane.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// The sum of two vectors, coordinate by coordinate.
struct LongVector {
  OneVector high, low;
};

HWY_INLINE LongVector exact_sum(const OneVector& a, const OneVector& b) {
  const OneVector high = plus(a, b), b_part = minus(high, a), a_part = minus(high, b_part);
  return {high, plus(minus(a, a_part), minus(b, b_part))};
}
HWY_INLINE LongVector exact_difference(const OneVector& a, const OneVector& b) {
  const OneVector high = minus(a, b), b_part = minus(high, a), a_part = minus(high, b_part);
  return {high, minus(minus(a, a_part), plus(b, b_part))};
}

/// Products coordinate by coordinate, as long as their errors do not underflow.
HWY_INLINE LongVector exact_products(const OneVector& u, const OneVector& v) {
#if HWY_TARGET <= HWY_AVX2
  const auto high = hn::Mul(u.xyz, v.xyz);
  return {{high}, {hn::MulSub(u.xyz, v.xyz, high)}};
#else
  const TwoPart x = exact_product(first_of(u.x), first_of(v.x)), y = exact_product(first_of(u.y), first_of(v.y)),
                z = exact_product(first_of(u.z), first_of(v.z));
  return {in_one(x.high, y.high, z.high), in_one(x.low, y.low, z.low)};
#endif
}
HWY_INLINE OneVector products(const OneVector& u, const OneVector& v) {
#if HWY_TARGET <= HWY_AVX2
  return {hn::Mul(u.xyz, v.xyz)};
#else
  return {hn::Mul(u.x, v.x), hn::Mul(u.y, v.y), hn::Mul(u.z, v.z)};
#endif
}
HWY_INLINE OneVector in_each(double s) {
#if HWY_TARGET <= HWY_AVX2
  return {hn::Set(Coordinates(), s)};
#else
  return in_one(s, s, s);
#endif
}

/// The high part is the sum, rounded.
HWY_INLINE LongVector renormalized(const LongVector& v) { return exact_sum(v.high, v.low); }

/// v + s · e. Four roundings of what is below the last places of the three: where |v.low| ≤ 2^-51 |v.high|, a
/// coordinate is off by less than 2^-102 (|v.high| + |s · e|).
HWY_INLINE LongVector moved(const LongVector& v, double s, const LongVector& e) {
  const OneVector share = in_each(s);
  const LongVector product = exact_products(share, e.high), sum = exact_sum(v.high, product.high);
  return {sum.high, plus(v.low, plus(plus(sum.low, product.low), products(share, e.low)))};
}

/// |v|², of a renormalized vector: off by less than 2^-99 of it, where nothing under- or overflows. Left out are
/// squares of low parts, 2^-106 of it; and what is added up below the last place of the first sum is less than 2^-49 of
/// it, in ten roundings.
HWY_INLINE TwoPart long_square(const LongVector& v) {
  const LongVector squares = exact_products(v.high, v.high);
  const OneVector mixed = products(v.high, v.low), rest = plus(squares.low, plus(mixed, mixed));
  const TwoPart first = two_sum(first_of(x_of(squares.high)), first_of(y_of(squares.high))),
                sum = two_sum(first.high, first_of(z_of(squares.high)));
  return fast_two_sum(sum.high, first_of(sum_of(rest)) + (first.low + sum.low));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
