// Vectors of numbers, and vectors of three of them: a pair of shapes, a ray, a triangle … in each lane. Included once
// for every SIMD level, so its guard toggles with Highway's instead of letting it in only once.
#if defined(TOCCATA_MATH_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_MATH_LANES_HPP
#undef TOCCATA_MATH_LANES_HPP
#else
#define TOCCATA_MATH_LANES_HPP
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "toccata/math/vec3.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// No multiplication is fused with an addition here, so that all levels find the same.

/// A vector in each lane.
template <class T>
struct LaneVector {
  using Number = hn::Vec<T>;
  using Mask = hn::Mask<T>;
  Number x, y, z;
};

template <class V>
using NumberOf = typename V::Number;
template <class V>
using MaskOf = typename V::Mask;
/// The tag of the lanes that such numbers are in.
template <class N>
using TagOf = hn::DFromV<N>;

// Doubles, as many as a level has lanes for, but for eight at most.

constexpr std::size_t most_lanes = 8;
using Tag = hn::CappedTag<double, most_lanes>;
using Number = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
using Vector = LaneVector<Tag>;
constexpr Tag tag;

// The same of floats.

using Floats = hn::CappedTag<float, most_lanes>;
using Float = hn::Vec<Floats>;
using FloatMask = hn::Mask<Floats>;
using FloatVector = LaneVector<Floats>;

/// The same number in all lanes.
template <class N>
HWY_INLINE N all(hn::TFromV<N> value) {
  return hn::Set(TagOf<N>(), value);
}
HWY_INLINE Number all(double value) { return hn::Set(tag, value); }

/// The same vector in all lanes.
HWY_INLINE Vector in_all(const Vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
template <class T>
HWY_INLINE LaneVector<T> in_all(T floats, const std::array<float, 3>& v) {
  return {hn::Set(floats, v[0]), hn::Set(floats, v[1]), hn::Set(floats, v[2])};
}

/// The bits of a mask, which say for each lane whether something holds: the first lane in bit 0; at most sixteen.
template <class T>
HWY_INLINE unsigned bits_of(T lanes, const hn::Mask<T>& mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(lanes, mask, bytes);
  if constexpr (hn::MaxLanes(T()) > 8) return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
  return bytes[0];
}

// a < b ? a : b and a > b ? a : b, which is what one instruction of x86 does.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
template <class N>
HWY_INLINE N lesser(const N& a, const N& b) {
  return hn::Min(a, b);
}
template <class N>
HWY_INLINE N greater(const N& a, const N& b) {
  return hn::Max(a, b);
}
#else
template <class N>
HWY_INLINE N lesser(const N& a, const N& b) {
  return hn::IfThenElse(hn::Lt(a, b), a, b);
}
template <class N>
HWY_INLINE N greater(const N& a, const N& b) {
  return hn::IfThenElse(hn::Gt(a, b), a, b);
}
#endif

/// NaN becomes `lower`.
template <class N>
HWY_INLINE N clamped_between(const N& value, const N& lower, const N& upper) {
  return lesser(greater(value, lower), upper);
}
template <class N>
HWY_INLINE N clamped_share(const N& value) {
  return clamped_between(value, hn::Zero(TagOf<N>()), all<N>(1));
}

template <class T>
HWY_INLINE hn::Vec<T> x_of(const LaneVector<T>& v) {
  return v.x;
}
template <class T>
HWY_INLINE hn::Vec<T> y_of(const LaneVector<T>& v) {
  return v.y;
}
template <class T>
HWY_INLINE hn::Vec<T> z_of(const LaneVector<T>& v) {
  return v.z;
}
template <class T>
HWY_INLINE LaneVector<T> plus(const LaneVector<T>& u, const LaneVector<T>& v) {
  return {hn::Add(u.x, v.x), hn::Add(u.y, v.y), hn::Add(u.z, v.z)};
}
template <class T>
HWY_INLINE LaneVector<T> minus(const LaneVector<T>& u, const LaneVector<T>& v) {
  return {hn::Sub(u.x, v.x), hn::Sub(u.y, v.y), hn::Sub(u.z, v.z)};
}
template <class T>
HWY_INLINE LaneVector<T> times(const hn::Vec<T>& s, const LaneVector<T>& v) {
  return {hn::Mul(s, v.x), hn::Mul(s, v.y), hn::Mul(s, v.z)};
}
template <class T>
HWY_INLINE LaneVector<T> negative(const LaneVector<T>& v) {
  return {hn::Neg(v.x), hn::Neg(v.y), hn::Neg(v.z)};
}
template <class T>
HWY_INLINE LaneVector<T> magnitudes_of(const LaneVector<T>& v) {
  return {hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)};
}
template <class T>
HWY_INLINE hn::Vec<T> sum_of(const LaneVector<T>& v) {
  return hn::Add(hn::Add(v.x, v.y), v.z);
}
/// The greatest magnitude of a coordinate.
template <class T>
HWY_INLINE hn::Vec<T> greatest_of(const LaneVector<T>& v) {
  return greater(greater(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}
template <class T>
HWY_INLINE hn::Vec<T> dot(const LaneVector<T>& u, const LaneVector<T>& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}
template <class T>
HWY_INLINE LaneVector<T> cross(const LaneVector<T>& u, const LaneVector<T>& v) {
  return {hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)), hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
          hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
}
/// By value: a vector that is replaced by what is selected would otherwise stay in memory when g++ compiles this.
template <class T>
HWY_INLINE LaneVector<T> select(hn::Mask<T> mask, LaneVector<T> yes, LaneVector<T> no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
