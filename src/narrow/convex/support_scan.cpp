// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/convex/support_scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "math/lanes.hpp"
#include "narrow/convex/support_scan.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE Vector vertices_at(const SupportScan& scan, Index i) {
  return {hn::LoadU(tag, scan.x + i), hn::LoadU(tag, scan.y + i), hn::LoadU(tag, scan.z + i)};
}

HWY_INLINE Number depth(const Vector& direction, const Vector& spread, const Vector& v) {
  return hn::Sub(dot(direction, v), dot(spread, magnitudes_of(v)));
}

constexpr Index few_vertices = 64;

/// Finds the least height first and then who has it: less to carry along than the number of the vertex.
HWY_INLINE Index least_of_few(const SupportScan& scan) {
  const Vector direction = in_all(scan.direction);
  HWY_ALIGN double heights[few_vertices];
  Number least = dot(direction, vertices_at(scan, 0));
  hn::Store(least, tag, heights);
  const auto lanes = static_cast<Index>(hn::Lanes(tag));
  for (Index i = lanes; i < scan.padded_count; i += lanes) {
    const Number height = dot(direction, vertices_at(scan, i));
    hn::Store(height, tag, heights + i);
    least = hn::Min(least, height);
  }
  least = hn::MinOfLanes(tag, least);
  std::uint64_t bits = 0;
  for (Index i = 0; i < scan.padded_count; i += lanes)
    bits |= std::uint64_t{bits_of(tag, hn::Eq(hn::Load(tag, heights + i), least))} << i;
  return bits == 0 ? 0 : static_cast<Index>(std::countr_zero(bits));
}

}  // namespace

Index least_at_this_level(const SupportScan& scan) {
  if (scan.padded_count <= few_vertices) return least_of_few(scan);
  // Four at a time, so that none waits for the one before.
  constexpr Index at_once = 4;
  const auto lanes = static_cast<Index>(hn::Lanes(tag));
  const Vector direction = in_all(scan.direction);
  const Number step = hn::Set(tag, static_cast<double>(lanes));
  const Number beyond = hn::Set(tag, static_cast<double>(scan.padded_count));
  Number least0 = hn::Inf(tag), least1 = least0, least2 = least0, least3 = least0;
  Number index0 = beyond, index1 = beyond, index2 = beyond, index3 = beyond;
  Number current = hn::Iota(tag, 0);
  const auto look = [&](Index i, Number& least, Number& index) HWY_ATTR {
    const Number height = dot(direction, vertices_at(scan, i));
    const auto lower = hn::Lt(height, least);  // of equal ones the first stays
    least = hn::IfThenElse(lower, height, least);
    index = hn::IfThenElse(lower, current, index);
    current = hn::Add(current, step);
  };
  Index i = 0;
  for (; i + at_once * lanes <= scan.padded_count; i += at_once * lanes) {
    look(i, least0, index0);
    look(i + lanes, least1, index1);
    look(i + 2 * lanes, least2, index2);
    look(i + 3 * lanes, least3, index3);
  }
  for (; i < scan.padded_count; i += lanes) look(i, least0, index0);
  const Number least = hn::MinOfLanes(tag, hn::Min(hn::Min(least0, least1), hn::Min(least2, least3)));
  const auto among_least = [&](const Number& height, const Number& index)
                               HWY_ATTR { return hn::IfThenElse(hn::Eq(height, least), index, beyond); };
  const Number first_of_lanes = hn::Min(hn::Min(among_least(least0, index0), among_least(least1, index1)),
                                        hn::Min(among_least(least2, index2), among_least(least3, index3)));
  const double first = hn::GetLane(hn::MinOfLanes(tag, first_of_lanes));
  return first < static_cast<double>(scan.padded_count) ? static_cast<Index>(first) : 0;
}

double least_depth_at_this_level(const SupportScan& scan) {
  const Vector direction = in_all(scan.direction), spread = in_all(scan.spread);
  Number least = hn::Inf(tag), all = hn::Zero(tag);
  for (Index i = 0; i < scan.padded_count; i += static_cast<Index>(hn::Lanes(tag))) {
    const Number own = depth(direction, spread, vertices_at(scan, i));
    least = hn::Min(least, own);
    all = hn::Add(all, own);  // a minimum may lose a NaN, a sum does not
  }
  const double sum = hn::GetLane(hn::SumOfLanes(tag, all));
  return sum != sum ? sum : hn::GetLane(hn::MinOfLanes(tag, least));
}

/// Those of the 64 vertices from `first` on whose depth is not above the bound, as bits.
HWY_INLINE std::uint64_t close_bits(const SupportScan& scan, Index first, const Vector& direction, const Vector& spread,
                                    Number bounds) {
  const Index end = std::min(first + 64, scan.padded_count);
  std::uint64_t bits = 0;
  for (Index i = first; i < end; i += static_cast<Index>(hn::Lanes(tag))) {
    // Asked so that NaN is close.
    const auto beyond = hn::Gt(depth(direction, spread, vertices_at(scan, i)), bounds);
    bits |= std::uint64_t{bits_of(tag, hn::Not(beyond))} << (i - first);
  }
  return end <= scan.count ? bits : bits & ~(~std::uint64_t{0} << (scan.count - first));
}

Index close_at_this_level(const SupportScan& scan, double bound, std::span<const Index> own, std::span<Index> found) {
  const Vector direction = in_all(scan.direction), spread = in_all(scan.spread);
  const Number bounds = hn::Set(tag, bound);
  Index count = 0;
  for (Index first = 0; first < scan.count; first += 64) {
    std::uint64_t bits = close_bits(scan, first, direction, spread, bounds);
    for (const Index i : own)
      if (i - first < 64) bits &= ~(std::uint64_t{1} << (i - first));
    for (; bits != 0; bits &= bits - 1, ++count)
      if (count < found.size()) found[count] = first + static_cast<Index>(std::countr_zero(bits));
  }
  return count;
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(least_at_this_level);
HWY_EXPORT(least_depth_at_this_level);
HWY_EXPORT(close_at_this_level);

SupportKernels support_kernels() {
  // Until the level is chosen, each pointer would be one that asks the processor anew in every call.
  hwy::ChosenTarget& chosen = hwy::GetChosenTarget();
  if (!chosen.IsInitialized()) chosen.Update(hwy::SupportedTargets());
  return {&HWY_DYNAMIC_DISPATCH(least_at_this_level), &HWY_DYNAMIC_DISPATCH(least_depth_at_this_level),
          &HWY_DYNAMIC_DISPATCH(close_at_this_level)};
}

}  // namespace toccata
#endif
