// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/support_scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "narrow/support_scan.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, 8>;
using Number = hn::Vec<Tag>;
constexpr Tag tag;

struct Along {
  Number x, y, z;
};

HWY_INLINE Along all_lanes(const Vec3& v) { return {hn::Set(tag, v.x), hn::Set(tag, v.y), hn::Set(tag, v.z)}; }

HWY_INLINE Along vertices_at(const SupportScan& scan, Index i) {
  return {hn::LoadU(tag, scan.x + i), hn::LoadU(tag, scan.y + i), hn::LoadU(tag, scan.z + i)};
}

HWY_INLINE Number dot(const Along& u, const Along& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}

HWY_INLINE Number depth(const Along& direction, const Along& spread, const Along& v) {
  const Along magnitude{hn::Abs(v.x), hn::Abs(v.y), hn::Abs(v.z)};
  return hn::Sub(dot(direction, v), dot(spread, magnitude));
}

}  // namespace

Index least_at_this_level(const SupportScan& scan) {
  const Along direction = all_lanes(scan.direction);
  const Number step = hn::Set(tag, static_cast<double>(hn::Lanes(tag)));
  Number current = hn::Iota(tag, 0);
  Number least = dot(direction, vertices_at(scan, 0)), index = current;
  for (Index i = static_cast<Index>(hn::Lanes(tag)); i < scan.padded_count; i += static_cast<Index>(hn::Lanes(tag))) {
    const Number height = dot(direction, vertices_at(scan, i));
    current = hn::Add(current, step);
    const auto lower = hn::Lt(height, least);  // of equal ones the first stays
    least = hn::IfThenElse(lower, height, least);
    index = hn::IfThenElse(lower, current, index);
  }
  const Number beyond = hn::Set(tag, static_cast<double>(scan.padded_count));
  const Number among_least = hn::IfThenElse(hn::Eq(least, hn::MinOfLanes(tag, least)), index, beyond);
  const double first = hn::GetLane(hn::MinOfLanes(tag, among_least));
  return first < static_cast<double>(scan.padded_count) ? static_cast<Index>(first) : 0;
}

double least_depth_at_this_level(const SupportScan& scan) {
  const Along direction = all_lanes(scan.direction), spread = all_lanes(scan.spread);
  Number least = hn::Inf(tag), all = hn::Zero(tag);
  for (Index i = 0; i < scan.padded_count; i += static_cast<Index>(hn::Lanes(tag))) {
    const Number own = depth(direction, spread, vertices_at(scan, i));
    least = hn::Min(least, own);
    all = hn::Add(all, own);  // a minimum may lose a NaN, a sum does not
  }
  const double sum = hn::GetLane(hn::SumOfLanes(tag, all));
  return sum != sum ? sum : hn::GetLane(hn::MinOfLanes(tag, least));
}

Index close_at_this_level(const SupportScan& scan, double bound, Index* found, Index capacity) {
  const Along direction = all_lanes(scan.direction), spread = all_lanes(scan.spread);
  const Number bounds = hn::Set(tag, bound);
  Index count = 0;
  for (Index i = 0; i < scan.padded_count; i += static_cast<Index>(hn::Lanes(tag))) {
    // Asked so that NaN is close.
    const auto beyond = hn::Gt(depth(direction, spread, vertices_at(scan, i)), bounds);
    if (hn::AllTrue(tag, beyond)) continue;
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, hn::Not(beyond), bits);
    for (Index lane = 0; lane < hn::Lanes(tag); ++lane) {
      if ((bits[0] >> lane & 1U) == 0) continue;
      if (count < capacity) found[count] = i + lane;
      ++count;
    }
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
  return {&HWY_DYNAMIC_DISPATCH(least_at_this_level), &HWY_DYNAMIC_DISPATCH(least_depth_at_this_level),
          &HWY_DYNAMIC_DISPATCH(close_at_this_level)};
}

}  // namespace toccata
#endif
