// The eight boxes of a block of a tree, in as few vectors of floats as a SIMD level needs for them. Included once for
// every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_TREES_BLOCK_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_TREES_BLOCK_LANES_HPP
#undef TOCCATA_TREES_BLOCK_LANES_HPP
#else
#define TOCCATA_TREES_BLOCK_LANES_HPP
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include "math/lanes.hpp"
#include "toccata/trees/wide_bvh.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

static_assert(WideBlock::width == most_lanes);

constexpr std::size_t part_lanes = hn::MaxLanes(Floats()), block_parts = WideBlock::width / part_lanes;
constexpr unsigned part_mask = (1U << part_lanes) - 1U;

using LaneIntegers = hn::CappedTag<std::int32_t, WideBlock::width>;
alignas(64) constexpr std::array<std::int32_t, WideBlock::width> lane_bit{1, 2, 4, 8, 16, 32, 64, 128};

// Sets of a block's lanes, as bits.

HWY_INLINE unsigned lanes_in_use(const WideBlock& block) { return (1U << block.count) - 1U; }

/// Those that are items.
HWY_INLINE unsigned items_of(const WideBlock& block) {
  const LaneIntegers d;
  unsigned items = 0;
  for (std::size_t first = 0; first < WideBlock::width; first += part_lanes)
    items |= bits_of(d, hn::Lt(hn::Load(d, block.child.data() + first), hn::Zero(d))) << first;
  return items;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
