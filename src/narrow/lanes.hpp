// Vectors of numbers, a pair of shapes in each lane. Included once for every SIMD level, so its guard toggles with
// Highway's instead of letting it in only once.
#if defined(TOCCATA_NARROW_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_LANES_HPP
#undef TOCCATA_NARROW_LANES_HPP
#else
#define TOCCATA_NARROW_LANES_HPP
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {  // a file may ask for fewer lanes, and these names mean other types then

namespace hn = hwy::HWY_NAMESPACE;
#ifndef TOCCATA_MOST_LANES
#define TOCCATA_MOST_LANES 8
#endif
using Tag = hn::CappedTag<double, TOCCATA_MOST_LANES>;
using Number = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

struct Vector {
  Number x, y, z;
};

HWY_INLINE Number all(double value) { return hn::Set(Tag(), value); }
HWY_INLINE Vector plus(const Vector& u, const Vector& v) {
  return {hn::Add(u.x, v.x), hn::Add(u.y, v.y), hn::Add(u.z, v.z)};
}
HWY_INLINE Vector minus(const Vector& u, const Vector& v) {
  return {hn::Sub(u.x, v.x), hn::Sub(u.y, v.y), hn::Sub(u.z, v.z)};
}
HWY_INLINE Vector times(const Number& s, const Vector& v) {
  return {hn::Mul(s, v.x), hn::Mul(s, v.y), hn::Mul(s, v.z)};
}
HWY_INLINE Vector negative(const Vector& v) { return {hn::Neg(v.x), hn::Neg(v.y), hn::Neg(v.z)}; }
HWY_INLINE Vector magnitudes_of(const Vector& v) { return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)}; }
HWY_INLINE Number dot(const Vector& u, const Vector& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}
HWY_INLINE Vector cross(const Vector& u, const Vector& v) {
  return {hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)), hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
          hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
}
HWY_INLINE Number lesser(const Number& a, const Number& b) { return hn::IfThenElse(hn::Lt(a, b), a, b); }
HWY_INLINE Number greater(const Number& a, const Number& b) { return hn::IfThenElse(hn::Gt(a, b), a, b); }
HWY_INLINE Vector select(const Mask& mask, const Vector& yes, const Vector& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}
/// NaN becomes `lower`.
HWY_INLINE Number clamped_between(const Number& value, const Number& lower, const Number& upper) {
  return lesser(hn::IfThenElse(hn::Gt(value, lower), value, lower), upper);
}
HWY_INLINE Number clamped_share(const Number& value) { return clamped_between(value, hn::Zero(Tag()), all(1)); }

HWY_INLINE Number load(const double* const* columns, std::size_t k, std::size_t i) {
  return hn::LoadU(Tag(), columns[k] + i);
}
HWY_INLINE Vector load_vector(const double* const* columns, std::size_t k, std::size_t i) {
  return {load(columns, k, i), load(columns, k + 1, i), load(columns, k + 2, i)};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
