// Rows of the columns of two arrays (pair_kernels.hpp), one in each lane. Included once for every SIMD level, like
// math/lanes.hpp.
#if defined(TOCCATA_NARROW_COLUMN_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_COLUMN_LANES_HPP
#undef TOCCATA_NARROW_COLUMN_LANES_HPP
#else
#define TOCCATA_NARROW_COLUMN_LANES_HPP
#endif

#include "math/lanes.hpp"
#include "narrow/primitives/pair_kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE Number load(const double* const* columns, std::size_t k, std::size_t i) {
  return hn::LoadU(tag, columns[k] + i);
}
HWY_INLINE Vector load_vector(const double* const* columns, std::size_t k, std::size_t i) {
  return {load(columns, k, i), load(columns, k + 1, i), load(columns, k + 2, i)};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
