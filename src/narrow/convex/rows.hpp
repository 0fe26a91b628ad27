// A row of four doubles in as many vectors as a SIMD level needs for it; the same bits at every level. Included once
// for each level, so its guard toggles with Highway's instead of letting it in only once.
#if defined(TOCCATA_NARROW_ROWS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_ROWS_HPP
#undef TOCCATA_NARROW_ROWS_HPP
#else
#define TOCCATA_NARROW_ROWS_HPP
#endif

#include <cstddef>
#include <cstdint>

#include "math/lanes.hpp"
#include "toccata/math/vec3.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

using RowTag = hn::CappedTag<double, 4>;
constexpr RowTag row_tag;
constexpr std::size_t row_lanes = hn::MaxLanes(row_tag), row_parts = 4 / row_lanes;

struct Row {
  hn::Vec<RowTag> part[row_parts];
};

template <class Function>
HWY_INLINE Row each(const Function& function) {
  Row result;
  for (std::size_t k = 0; k < row_parts; ++k) result.part[k] = function(k);
  return result;
}

HWY_INLINE Row load(const double* from) {
  return each([&](std::size_t k) { return hn::LoadU(row_tag, from + k * row_lanes); });
}
/// A row of three doubles, and 0.
HWY_INLINE Row load_three(const Vec3& v) {
#if HWY_TARGET <= HWY_AVX2
  return {{hn::MaskedLoad(hn::FirstN(row_tag, 3), row_tag, &v.x)}};
#else
  alignas(32) const double four[4] = {v.x, v.y, v.z, 0};
  return load(four);
#endif
}
HWY_INLINE void store(const Row& row, double* to) {
  for (std::size_t k = 0; k < row_parts; ++k) hn::StoreU(row.part[k], row_tag, to + k * row_lanes);
}
HWY_INLINE Row row_of(double value) {
  return each([&](std::size_t) { return hn::Set(row_tag, value); });
}
HWY_INLINE Row operator+(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Add(u.part[k], v.part[k]); });
}
HWY_INLINE Row operator-(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Sub(u.part[k], v.part[k]); });
}
HWY_INLINE Row operator*(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Mul(u.part[k], v.part[k]); });
}
HWY_INLINE Row operator*(double s, const Row& v) { return row_of(s) * v; }
HWY_INLINE Row operator/(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Div(u.part[k], v.part[k]); });
}
HWY_INLINE Row magnitude(const Row& v) {
  return each([&](std::size_t k) { return hn::Abs(v.part[k]); });
}
HWY_INLINE Row lesser(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Min(u.part[k], v.part[k]); });
}
HWY_INLINE Row greater(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Max(u.part[k], v.part[k]); });
}

/// For which of the four something holds.
struct RowMask {
  hn::Mask<RowTag> part[row_parts];
};

template <class Function>
HWY_INLINE RowMask each_mask(const Function& function) {
  RowMask result;
  for (std::size_t k = 0; k < row_parts; ++k) result.part[k] = function(k);
  return result;
}
HWY_INLINE RowMask operator<(const Row& u, const Row& v) {
  return each_mask([&](std::size_t k) { return hn::Lt(u.part[k], v.part[k]); });
}
HWY_INLINE RowMask operator<=(const Row& u, const Row& v) {
  return each_mask([&](std::size_t k) { return hn::Le(u.part[k], v.part[k]); });
}
HWY_INLINE RowMask operator==(const Row& u, const Row& v) {
  return each_mask([&](std::size_t k) { return hn::Eq(u.part[k], v.part[k]); });
}
HWY_INLINE RowMask operator&(const RowMask& u, const RowMask& v) {
  return each_mask([&](std::size_t k) { return hn::And(u.part[k], v.part[k]); });
}
HWY_INLINE RowMask operator|(const RowMask& u, const RowMask& v) {
  return each_mask([&](std::size_t k) { return hn::Or(u.part[k], v.part[k]); });
}
HWY_INLINE Row select(const RowMask& mask, const Row& yes, const Row& no) {
  return each([&](std::size_t k) { return hn::IfThenElse(mask.part[k], yes.part[k], no.part[k]); });
}
/// A bit each.
HWY_INLINE unsigned bits_of(const RowMask& mask) {
  unsigned bits = 0;
  for (std::size_t k = 0; k < row_parts; ++k) bits |= bits_of(row_tag, mask.part[k]) << (k * row_lanes);
  return bits;
}

/// The row with the number j + 1 in place of the j-th, in the first three.
HWY_INLINE Row next(const Row& row) {
#if HWY_TARGET <= HWY_AVX2
  alignas(32) static constexpr std::int64_t order[4] = {1, 2, 0, 3};
  return {{hn::TableLookupLanes(row.part[0], hn::SetTableIndices(row_tag, order))}};
#else
  alignas(64) double thrice[8];
  store(row, thrice);
  thrice[3] = thrice[0];
  thrice[4] = thrice[1];
  return load(thrice + 1);
#endif
}

/// The sum of the first three.
HWY_INLINE double sum_of_three(const Row& row) {
  const Row after = next(row);
  return hn::GetLane(((row + after) + next(after)).part[0]);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
