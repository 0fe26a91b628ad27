// Vectors of one lane: of one pair of shapes. They select without a branch. Included once for every SIMD level, like
// math/lanes.hpp.
#if defined(TOCCATA_NARROW_ONE_LANE_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_ONE_LANE_HPP
#undef TOCCATA_NARROW_ONE_LANE_HPP
#else
#define TOCCATA_NARROW_ONE_LANE_HPP
#endif

#include "math/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

using OneTag = hn::CappedTag<double, 1>;
using OneNumber = hn::Vec<OneTag>;
using OneMask = hn::Mask<OneTag>;

#if HWY_TARGET <= HWY_AVX2
// The three coordinates are lanes: a third of the instructions, and the same bits.

using Coordinates = hn::FixedTag<double, 4>;  // the last does not matter

struct OneVector {
  using Number = OneNumber;
  using Mask = OneMask;
  hn::Vec<Coordinates> xyz;
};

/// The last lane is 0.
HWY_INLINE OneVector in_one(const Vec3& v) {
  return {hn::MaskedLoad(hn::FirstN(Coordinates(), 3), Coordinates(), &v.x)};
}
HWY_INLINE OneVector in_one(double x, double y, double z) {
  constexpr hn::Half<Coordinates> two;
  return {hn::Combine(Coordinates(), hn::Set(two, z), hn::InterleaveLower(two, hn::Set(two, x), hn::Set(two, y)))};
}
HWY_INLINE OneNumber x_of(const OneVector& v) { return hn::LowerHalf(hn::LowerHalf(v.xyz)); }
HWY_INLINE OneNumber y_of(const OneVector& v) {
  const auto lower = hn::LowerHalf(v.xyz);
  return hn::LowerHalf(hn::InterleaveUpper(hn::Half<Coordinates>(), lower, lower));
}
HWY_INLINE OneNumber z_of(const OneVector& v) { return hn::LowerHalf(hn::UpperHalf(hn::Half<Coordinates>(), v.xyz)); }
HWY_INLINE OneVector plus(const OneVector& u, const OneVector& v) { return {hn::Add(u.xyz, v.xyz)}; }
HWY_INLINE OneVector minus(const OneVector& u, const OneVector& v) { return {hn::Sub(u.xyz, v.xyz)}; }
HWY_INLINE OneVector times(const OneNumber& s, const OneVector& v) {
  return {hn::Mul(hn::Set(Coordinates(), hn::GetLane(s)), v.xyz)};
}
HWY_INLINE OneVector negative(const OneVector& v) { return {hn::Neg(v.xyz)}; }
HWY_INLINE OneVector magnitudes_of(const OneVector& v) { return {hn::Abs(v.xyz)}; }
HWY_INLINE OneNumber sum_of(const OneVector& v) { return hn::Add(hn::Add(x_of(v), y_of(v)), z_of(v)); }
HWY_INLINE OneNumber dot(const OneVector& u, const OneVector& v) { return sum_of({hn::Mul(u.xyz, v.xyz)}); }
HWY_INLINE OneVector next(const OneVector& v) {
  alignas(32) static constexpr std::int64_t order[4] = {1, 2, 0, 3};
  return {hn::TableLookupLanes(v.xyz, hn::SetTableIndices(Coordinates(), order))};
}
HWY_INLINE OneVector cross(const OneVector& u, const OneVector& v) {
  // The product's z comes first.
  return next({hn::Sub(hn::Mul(u.xyz, next(v).xyz), hn::Mul(next(u).xyz, v.xyz))});
}
HWY_INLINE OneNumber greatest_of(const OneVector& v) {
  const OneVector size = magnitudes_of(v);
  return greater(greater(x_of(size), y_of(size)), z_of(size));
}
HWY_INLINE OneVector select(const OneMask& mask, const OneVector& yes, const OneVector& no) {
  const auto bits = hn::Set(Coordinates(), hn::GetLane(hn::VecFromMask(OneTag(), mask)));
  return {hn::IfVecThenElse(bits, yes.xyz, no.xyz)};
}

/// What `op` makes of each coordinate.
template <class Op, class... More>
HWY_INLINE OneVector each(const Op& op, const OneVector& v, const More&... more) {
  return {op(v.xyz, more.xyz...)};
}
HWY_INLINE OneVector in_each(const OneVector& /*like*/, const OneNumber& s) {
  return {hn::Set(Coordinates(), hn::GetLane(s))};
}
HWY_INLINE OneVector in_lanes_of(const OneVector& /*like*/, const Vec3& v) { return in_one(v); }

#else

using OneVector = LaneVector<OneTag>;

HWY_INLINE OneVector in_one(double x, double y, double z) {
  return {all<OneNumber>(x), all<OneNumber>(y), all<OneNumber>(z)};
}
HWY_INLINE OneVector in_one(const Vec3& v) { return in_one(v.x, v.y, v.z); }

#endif

HWY_INLINE double first_of(const OneNumber& value) { return hn::GetLane(value); }
HWY_INLINE OneVector scaled(double s, const OneVector& v) { return times(all<OneNumber>(s), v); }

HWY_INLINE void store(const OneVector& v, Vec3& to) {
#if HWY_TARGET <= HWY_AVX2
  hn::StoreU(hn::LowerHalf(v.xyz), hn::Half<Coordinates>(), &to.x);
  to.z = first_of(z_of(v));
#else
  to = {first_of(v.x), first_of(v.y), first_of(v.z)};
#endif
}

// The same of one or many in the lanes.

template <class T, class Op, class... More>
HWY_INLINE LaneVector<T> each(const Op& op, const LaneVector<T>& v, const More&... more) {
  return {op(v.x, more.x...), op(v.y, more.y...), op(v.z, more.z...)};
}
/// A number at each coordinate.
template <class T>
HWY_INLINE LaneVector<T> in_each(const LaneVector<T>& /*like*/, const hn::Vec<T>& s) {
  return {s, s, s};
}
/// A vector in all lanes of vectors such as `like`.
template <class T>
HWY_INLINE LaneVector<T> in_lanes_of(const LaneVector<T>& /*like*/, const Vec3& v) {
  return {hn::Set(T(), v.x), hn::Set(T(), v.y), hn::Set(T(), v.z)};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
