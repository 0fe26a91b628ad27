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
#include <cstdint>

#include "toccata/math/vec3.hpp"

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

HWY_INLINE Number all(double value) { return hn::Set(Tag(), value); }

#if TOCCATA_MOST_LANES == 1 && HWY_TARGET <= HWY_AVX2
// Of one pair the three coordinates are lanes: a third of the instructions, and the same bits.

using Coordinates = hn::FixedTag<double, 4>;  // the last does not matter

struct Vector {
  hn::Vec<Coordinates> xyz;
};

/// The last lane is 0.
HWY_INLINE Vector lanes_of(const Vec3& v) {
  return {hn::MaskedLoad(hn::FirstN(Coordinates(), 3), Coordinates(), &v.x)};
}
HWY_INLINE Number x_of(const Vector& v) { return hn::LowerHalf(hn::LowerHalf(v.xyz)); }
HWY_INLINE Number y_of(const Vector& v) {
  const auto lower = hn::LowerHalf(v.xyz);
  return hn::LowerHalf(hn::InterleaveUpper(hn::Half<Coordinates>(), lower, lower));
}
HWY_INLINE Number z_of(const Vector& v) { return hn::LowerHalf(hn::UpperHalf(hn::Half<Coordinates>(), v.xyz)); }
HWY_INLINE Vector plus(const Vector& u, const Vector& v) { return {hn::Add(u.xyz, v.xyz)}; }
HWY_INLINE Vector minus(const Vector& u, const Vector& v) { return {hn::Sub(u.xyz, v.xyz)}; }
HWY_INLINE Vector times(const Number& s, const Vector& v) {
  return {hn::Mul(hn::Set(Coordinates(), hn::GetLane(s)), v.xyz)};
}
HWY_INLINE Vector negative(const Vector& v) { return {hn::Neg(v.xyz)}; }
HWY_INLINE Vector magnitudes_of(const Vector& v) { return {hn::Abs(v.xyz)}; }
HWY_INLINE Number sum_of(const Vector& v) { return hn::Add(hn::Add(x_of(v), y_of(v)), z_of(v)); }
HWY_INLINE Number dot(const Vector& u, const Vector& v) { return sum_of({hn::Mul(u.xyz, v.xyz)}); }
HWY_INLINE Vector next(const Vector& v) {
  alignas(32) static constexpr std::int64_t order[4] = {1, 2, 0, 3};
  return {hn::TableLookupLanes(v.xyz, hn::SetTableIndices(Coordinates(), order))};
}
HWY_INLINE Vector cross(const Vector& u, const Vector& v) {
  // The product's z comes first.
  return next({hn::Sub(hn::Mul(u.xyz, next(v).xyz), hn::Mul(next(u).xyz, v.xyz))});
}
HWY_INLINE Vector select(const Mask& mask, const Vector& yes, const Vector& no) {
  const auto bits = hn::Set(Coordinates(), hn::GetLane(hn::VecFromMask(Tag(), mask)));
  return {hn::IfVecThenElse(bits, yes.xyz, no.xyz)};
}

#else

struct Vector {
  Number x, y, z;
};

HWY_INLINE Vector lanes_of(const Vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE Number x_of(const Vector& v) { return v.x; }
HWY_INLINE Number y_of(const Vector& v) { return v.y; }
HWY_INLINE Number z_of(const Vector& v) { return v.z; }
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
HWY_INLINE Number sum_of(const Vector& v) { return hn::Add(hn::Add(v.x, v.y), v.z); }
HWY_INLINE Number dot(const Vector& u, const Vector& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}
HWY_INLINE Vector cross(const Vector& u, const Vector& v) {
  return {hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)), hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
          hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
}
HWY_INLINE Vector select(const Mask& mask, const Vector& yes, const Vector& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

HWY_INLINE Number load(const double* const* columns, std::size_t k, std::size_t i) {
  return hn::LoadU(Tag(), columns[k] + i);
}
HWY_INLINE Vector load_vector(const double* const* columns, std::size_t k, std::size_t i) {
  return {load(columns, k, i), load(columns, k + 1, i), load(columns, k + 2, i)};
}
#endif

// a < b ? a : b and a > b ? a : b, which is what one instruction of x86 does.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
HWY_INLINE Number lesser(const Number& a, const Number& b) { return hn::Min(a, b); }
HWY_INLINE Number greater(const Number& a, const Number& b) { return hn::Max(a, b); }
#else
HWY_INLINE Number lesser(const Number& a, const Number& b) { return hn::IfThenElse(hn::Lt(a, b), a, b); }
HWY_INLINE Number greater(const Number& a, const Number& b) { return hn::IfThenElse(hn::Gt(a, b), a, b); }
#endif
/// NaN becomes `lower`.
HWY_INLINE Number clamped_between(const Number& value, const Number& lower, const Number& upper) {
  return lesser(greater(value, lower), upper);
}
HWY_INLINE Number clamped_share(const Number& value) { return clamped_between(value, hn::Zero(Tag()), all(1)); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
