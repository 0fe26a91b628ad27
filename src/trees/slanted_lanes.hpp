// Which boxes of a block lie beyond something along straight and slanted axes. Included once for every SIMD level, like
// math/lanes.hpp.
#if defined(TOCCATA_TREES_SLANTED_LANES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_TREES_SLANTED_LANES_HPP
#undef TOCCATA_TREES_SLANTED_LANES_HPP
#else
#define TOCCATA_TREES_SLANTED_LANES_HPP
#endif

#include <array>
#include <cstddef>

#include "trees/block_lanes.hpp"
#include "trees/wide_probe.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// The lanes first, first + 1 … of a block, as vectors.
struct BlockLanes {
  explicit BlockLanes(const WideBlock& block, std::size_t first)
      : cx(hn::Load(Floats(), block.centre[0].data() + first)),
        cy(hn::Load(Floats(), block.centre[1].data() + first)),
        cz(hn::Load(Floats(), block.centre[2].data() + first)),
        ex(hn::Load(Floats(), block.extent[0].data() + first)),
        ey(hn::Load(Floats(), block.extent[1].data() + first)),
        ez(hn::Load(Floats(), block.extent[2].data() + first)) {}
  Float cx, cy, cz, ex, ey, ez;
};

template <class V>
HWY_INLINE V along(const std::array<float, 3>& form, V x, V y, V z) {
  const Floats d;
  return hn::Add(hn::Add(hn::Mul(hn::Set(d, form[0]), x), hn::Mul(hn::Set(d, form[1]), y)),
                 hn::Mul(hn::Set(d, form[2]), z));
}

/// Every comparison is written so that what is not a number keeps the lane.
HWY_INLINE FloatMask is_beyond(Float centre, Float extent, float at, float reach) {
  const Floats d;
  return hn::Gt(hn::Abs(hn::Sub(centre, hn::Set(d, at))), hn::Add(extent, hn::Set(d, reach)));
}

HWY_INLINE FloatMask is_beyond_along(const SlantedForm& form, const BlockLanes& l, float at, float reach) {
  return is_beyond(along(form.own, l.cx, l.cy, l.cz), along(form.size, l.ex, l.ey, l.ez), at, reach);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
