// The eight boxes of a block of a tree, in as few vectors of floats as a SIMD level needs for them. Included once for
// every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_TREES_BLOCK_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_TREES_BLOCK_LANES_HPP
#undef TOCCATA_TREES_BLOCK_LANES_HPP
#else
#define TOCCATA_TREES_BLOCK_LANES_HPP
#endif

#include <cstddef>

#include "math/lanes.hpp"
#include "toccata/trees/wide_bvh.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

static_assert(WideBlock::width == most_lanes);

constexpr std::size_t part_lanes = hn::MaxLanes(Floats()), block_parts = WideBlock::width / part_lanes;
constexpr unsigned part_mask = (1U << part_lanes) - 1U;

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
