// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/triangles/classify_pairs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>
#include <bit>
#include <cstdint>

#include "math/filter.hpp"
#include "math/lanes.hpp"
#include "narrow/triangles/triangle_pair_block.hpp"

#ifndef TOCCATA_NARROW_CLASSIFY_PAIRS_ONCE
#define TOCCATA_NARROW_CLASSIFY_PAIRS_ONCE
namespace toccata {

// What the levels share. It is defined here, before any level's instructions are switched on.
using PoseNumbers = const double*;  ///< twelve: R row by row, then t; null: those of no motion at all

inline double* lanes_of(TrianglePairBlock::Corners& corners, std::size_t corner, std::size_t axis) {
  return corners[corner][axis].data();
}

}  // namespace toccata
#endif

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

static_assert(TrianglePairBlock::lanes == most_lanes);

// Below, a value stands for several pairs at a time. No multiplication is ever fused with an addition: what a pose
// makes of a vertex is the truth, and the filter's bounds should decide the same pairs at every level. All is inlined
// by force: g++ passes such values in memory otherwise, which costs a fifth.

struct CornersInLanes {
  Vector p, q, r;
};

HWY_INLINE Vector least(const Vector& u, const Vector& v) {
  return {hn::Min(u.x, v.x), hn::Min(u.y, v.y), hn::Min(u.z, v.z)};
}
HWY_INLINE Vector greatest(const Vector& u, const Vector& v) {
  return {hn::Max(u.x, v.x), hn::Max(u.y, v.y), hn::Max(u.z, v.z)};
}

// Posing.

HWY_INLINE Number row_times(PoseNumbers row, double offset, const Vector& v) {
  const Number xy = hn::Add(hn::Mul(hn::Set(tag, row[0]), v.x), hn::Mul(hn::Set(tag, row[1]), v.y));
  return hn::Add(hn::Add(xy, hn::Mul(hn::Set(tag, row[2]), v.z)), hn::Set(tag, offset));
}

/// The corner posed as `transform` does it, and put back in its place.
HWY_INLINE Vector posed(TrianglePairBlock::Corners& corners, std::size_t corner, std::size_t lane, PoseNumbers pose) {
  double* x = lanes_of(corners, corner, 0) + lane;
  double* y = lanes_of(corners, corner, 1) + lane;
  double* z = lanes_of(corners, corner, 2) + lane;
  const Vector local{hn::Load(tag, x), hn::Load(tag, y), hn::Load(tag, z)};
  // No motion is the addition of 0, to the bit: it changes the sign of a zero.
  const Number zero = hn::Zero(tag);
  const Vector world = pose == nullptr ? Vector{hn::Add(local.x, zero), hn::Add(local.y, zero), hn::Add(local.z, zero)}
                                       : Vector{row_times(pose, pose[9], local), row_times(pose + 3, pose[10], local),
                                                row_times(pose + 6, pose[11], local)};
  hn::Store(world.x, tag, x);
  hn::Store(world.y, tag, y);
  hn::Store(world.z, tag, z);
  return world;
}

HWY_INLINE CornersInLanes posed(TrianglePairBlock::Corners& corners, std::size_t lane, PoseNumbers pose) {
  return {posed(corners, 0, lane, pose), posed(corners, 1, lane, pose), posed(corners, 2, lane, pose)};
}

// Boxes.

struct BoxInLanes {
  Vector low, high;
};

HWY_INLINE BoxInLanes box_of(const CornersInLanes& t) {
  return {least(least(t.p, t.q), t.r), greatest(greatest(t.p, t.q), t.r)};
}
HWY_INLINE BoxInLanes join(const BoxInLanes& a, const BoxInLanes& b) {
  return {least(a.low, b.low), greatest(a.high, b.high)};
}
HWY_INLINE Vector size(const BoxInLanes& box) { return minus(box.high, box.low); }

HWY_INLINE Mask disjoint(Number low_a, Number high_a, Number low_b, Number high_b) {
  return hn::Or(hn::Gt(low_a, high_b), hn::Gt(low_b, high_a));
}

HWY_INLINE Mask disjoint(const BoxInLanes& a, const BoxInLanes& b) {
  return hn::Or(hn::Or(disjoint(a.low.x, a.high.x, b.low.x, b.high.x), disjoint(a.low.y, a.high.y, b.low.y, b.high.y)),
                disjoint(a.low.z, a.high.z, b.low.z, b.high.z));
}

/// The error bound of `filtered_triple_product` for all u, v, w with differences up to these. Rounding is monotone, so
/// every number on the way is at least its counterpart there, the bound too; and where that is infinite or NaN, so is
/// this. Hence the proof there serves here.
HWY_INLINE Number error_bound(const Vector& u, const Vector& v, const Vector& w) {
  const Number floor = hn::Set(tag, filter::floor);
  const Vector m{hn::Add(hn::Add(hn::Mul(u.y, v.z), floor), hn::Mul(u.z, v.y)),
                 hn::Add(hn::Add(hn::Mul(u.z, v.x), floor), hn::Mul(u.x, v.z)),
                 hn::Add(hn::Add(hn::Mul(u.x, v.y), floor), hn::Mul(u.y, v.x))};
  return hn::Mul(hn::Set(tag, filter::triple_product_bound), hn::Add(dot(m, w), floor));
}

// Sides of planes. A NaN is never above anything, so a comparison that must not be fooled by one asks for "greater".

struct Heights {
  Number p, q, r;
};

HWY_INLINE Heights heights_over(const CornersInLanes& plane, const CornersInLanes& t) {
  const Vector normal = cross(minus(plane.q, plane.p), minus(plane.r, plane.p));
  return {dot(normal, minus(t.p, plane.p)), dot(normal, minus(t.q, plane.p)), dot(normal, minus(t.r, plane.p))};
}

HWY_INLINE Mask exceeds(Number value, Number error) { return hn::Gt(hn::Abs(value), error); }
HWY_INLINE Mask positive(Number value) { return hn::Gt(value, hn::Zero(tag)); }

struct CornerSides {
  Mask certain;  ///< all three
  Mask p, q, r;  ///< above the plane
};

HWY_INLINE CornerSides sides_of(const Heights& h, Number error) {
  return {hn::And(hn::And(exceeds(h.p, error), exceeds(h.q, error)), exceeds(h.r, error)), positive(h.p), positive(h.q),
          positive(h.r)};
}

/// Where the sides are certain: some above and some below.
HWY_INLINE Mask straddle(const CornerSides& s) { return hn::Or(hn::Xor(s.p, s.q), hn::Xor(s.q, s.r)); }

/// No height is finite where a coordinate is not.
HWY_INLINE Mask finite(const Heights& h) {
  const Number infinity = hn::Inf(tag);
  return hn::Lt(hn::Abs(hn::Add(hn::Add(h.p, h.q), h.r)), infinity);
}

// Intervals on the line of both planes (plane_intervals.hpp).

/// The corner without company on its side, and the other ends of the two edges through which the interval starts and
/// ends.
struct IntervalEdges {
  Vector apex, start, end;
  Mask apex_above;
};

HWY_INLINE IntervalEdges edges_of_interval(const CornersInLanes& t, const CornerSides& s) {
  const Mask apex_not_p = hn::Xor(s.q, s.r), apex_not_q = hn::Xor(s.p, s.r);
  return {select(apex_not_p, select(apex_not_q, t.r, t.q), t.p),
          // The other end of the rising edge has another side than the corner after it, or before it.
          select(hn::AndNot(s.r, s.q), t.p, select(hn::AndNot(s.p, s.r), t.q, t.r)),
          select(hn::AndNot(s.q, s.r), t.p, select(hn::AndNot(s.r, s.p), t.q, t.r)), hn::Xor(hn::Xor(s.p, s.q), s.r)};
}

struct Verdict {
  Mask apart, intersection;
  Mask b_inside_at_first, b_inside_at_last;
};

/// With `order` as in plane_intervals.hpp, of edges that are named by the apex and another corner. An apex above is the
/// wrong end to name first; each turns the sign.
HWY_INLINE Verdict compare_intervals(const IntervalEdges& a, const IntervalEdges& b, Number error) {
  const Vector between = minus(b.apex, a.apex);
  const Vector at_start = cross(minus(a.start, a.apex), between), at_end = cross(minus(a.end, a.apex), between);
  const Vector start_b = minus(b.start, b.apex), end_b = minus(b.end, b.apex);
  const Number turn = hn::IfThenElseZero(hn::Xor(a.apex_above, b.apex_above), hn::Set(tag, -0.0));
  const Number a_starts_b_ends = hn::Xor(dot(at_start, start_b), turn);
  const Number b_starts_a_ends = hn::Xor(dot(at_end, end_b), hn::Xor(turn, hn::Set(tag, -0.0)));
  const Number first = hn::Xor(dot(at_start, end_b), turn);
  const Number last = hn::Xor(dot(at_end, start_b), hn::Xor(turn, hn::Set(tag, -0.0)));
  const Number least_error = hn::Neg(error);
  return {hn::Or(hn::Lt(a_starts_b_ends, least_error), hn::Lt(b_starts_a_ends, least_error)),
          hn::And(hn::And(hn::Gt(a_starts_b_ends, error), hn::Gt(b_starts_a_ends, error)),
                  hn::And(exceeds(first, error), exceeds(last, error))),
          positive(first), positive(last)};
}

// Neighbours.

HWY_INLINE Mask equal(const Vector& u, const Vector& v) {
  return hn::And(hn::And(hn::Eq(u.x, v.x), hn::Eq(u.y, v.y)), hn::Eq(u.z, v.z));
}

/// Which corners of a triangle have a twin in the other.
struct Shared {
  Mask p, q, r;
};

HWY_INLINE Mask has_twin(const Vector& corner, const CornersInLanes& other) {
  return hn::Or(hn::Or(equal(corner, other.p), equal(corner, other.q)), equal(corner, other.r));
}
HWY_INLINE Shared shared_corners(const CornersInLanes& t, const CornersInLanes& other) {
  return {has_twin(t.p, other), has_twin(t.q, other), has_twin(t.r, other)};
}

/// Some corners are shared, and all others certainly on one side of the other's plane: it has only the hull of those in
/// it.
HWY_INLINE Mask stands_on_shared(const Shared& shared, const Heights& h, Number error) {
  const Number below = hn::Neg(error);
  const Mask all_above = hn::And(hn::And(hn::Or(shared.p, hn::Gt(h.p, error)), hn::Or(shared.q, hn::Gt(h.q, error))),
                                 hn::Or(shared.r, hn::Gt(h.r, error)));
  const Mask all_below = hn::And(hn::And(hn::Or(shared.p, hn::Lt(h.p, below)), hn::Or(shared.q, hn::Lt(h.q, below))),
                                 hn::Or(shared.r, hn::Lt(h.r, below)));
  const Mask some = hn::Or(hn::Or(shared.p, shared.q), shared.r), all = hn::And(hn::And(shared.p, shared.q), shared.r);
  return hn::And(hn::AndNot(all, some), hn::Or(all_above, all_below));
}

/// For a triangle that shares one corner and has the others certainly on two sides of the other's plane: whether the
/// one after the shared corner is above.
struct Fan {
  Mask known, next_above;
};

HWY_INLINE Fan fan_of(const Shared& shared, const Heights& h, Number error) {
  const Mask one =
      hn::AndNot(hn::And(hn::And(shared.p, shared.q), shared.r), hn::Xor(hn::Xor(shared.p, shared.q), shared.r));
  const Mask certain = hn::And(hn::And(hn::Or(shared.p, exceeds(h.p, error)), hn::Or(shared.q, exceeds(h.q, error))),
                               hn::Or(shared.r, exceeds(h.r, error)));
  const Mask p = positive(h.p), q = positive(h.q), r = positive(h.r);
  const Mask next = hn::Or(hn::Or(hn::And(shared.p, q), hn::And(shared.q, r)), hn::And(shared.r, p));
  const Mask last = hn::Or(hn::Or(hn::And(shared.p, r), hn::And(shared.q, p)), hn::And(shared.r, q));
  return {hn::And(hn::And(one, certain), hn::Xor(next, last)), next};
}

/// They have only the corner in common that they share. With it for the origin, a's other corners q and r in turn, and
/// n for a's normal and m for b's: where q is above b's plane and r below, a reaches from the corner along n × m, for
/// m × (q × r) = q (m · r) − r (m · q) is a negative multiple of where the edge q r crosses the plane. The same of b,
/// with m × n.
HWY_INLINE Mask part_at_corner(const Fan& a, const Fan& b) {
  return hn::AndNot(hn::Xor(a.next_above, b.next_above), hn::And(a.known, b.known));
}

// Blocks.

HWY_INLINE std::uint64_t bits(const Mask& mask) { return bits_of(tag, mask); }

HWY_INLINE std::uint64_t bits(const CornerSides& s) { return bits(s.p) | bits(s.q) << 8U | bits(s.r) << 16U; }

/// The verdicts of as many lanes as a vector has, from bit 0 on.
struct LaneVerdicts {
  std::uint64_t intersection = 0, unknown = 0, signs = 0;
};

/// How two triangles are related to each other that a block holds.
enum class Kin { of_two_meshes, of_one_mesh };

template <Kin kin>
HWY_INLINE LaneVerdicts classify_lanes(TrianglePairBlock& block, std::size_t lane, PoseNumbers pose_a,
                                       PoseNumbers pose_b) {
  const CornersInLanes a = posed(block.a, lane, pose_a), b = posed(block.b, lane, pose_b);
  const BoxInLanes box_a = box_of(a), box_b = box_of(b);
  const Vector size_a = size(box_a), size_b = size(box_b), size_both = size(join(box_a, box_b));
  const Heights heights_b = heights_over(a, b), heights_a = heights_over(b, a);
  const Number error_b = error_bound(size_a, size_a, size_both), error_a = error_bound(size_b, size_b, size_both);
  const CornerSides of_b = sides_of(heights_b, error_b);
  const CornerSides of_a = sides_of(heights_a, error_a);
  const Mask across_a = straddle(of_a), across_b = straddle(of_b);
  Mask apart = hn::Or(hn::And(disjoint(box_a, box_b), finite(heights_b)),
                      hn::Or(hn::AndNot(across_a, of_a.certain), hn::AndNot(across_b, of_b.certain)));
  if constexpr (kin == Kin::of_one_mesh) {
    const Shared shared_a = shared_corners(a, b), shared_b = shared_corners(b, a);
    const Mask stands =
        hn::Or(stands_on_shared(shared_b, heights_b, error_b), stands_on_shared(shared_a, heights_a, error_a));
    const Mask parts = part_at_corner(fan_of(shared_a, heights_a, error_a), fan_of(shared_b, heights_b, error_b));
    apart = hn::Or(apart, hn::Or(stands, parts));
  }
  const Mask general = hn::AndNot(apart, hn::And(of_a.certain, of_b.certain));
  LaneVerdicts result;
  result.unknown = bits(hn::Not(apart));
  if (hn::AllFalse(tag, general)) return result;
  const Verdict verdict =
      compare_intervals(edges_of_interval(a, of_a), edges_of_interval(b, of_b), error_bound(size_a, size_both, size_b));
  result.intersection = bits(hn::And(general, verdict.intersection));
  result.unknown &= ~(result.intersection | bits(hn::And(general, verdict.apart)));
  result.signs =
      bits(of_a) | bits(of_b) << 24U | bits(verdict.b_inside_at_first) << 48U | bits(verdict.b_inside_at_last) << 56U;
  return result;
}

template <Kin kin>
void classify(TrianglePairBlock& block, PoseNumbers pose_a, PoseNumbers pose_b) {
  LaneVerdicts all;
  for (std::size_t lane = 0; lane < TrianglePairBlock::lanes; lane += hn::Lanes(tag)) {
    const LaneVerdicts some = classify_lanes<kin>(block, lane, pose_a, pose_b);
    all.intersection |= some.intersection << lane;
    all.unknown |= some.unknown << lane;
    all.signs |= some.signs << lane;
  }
  const std::uint64_t used = (std::uint64_t{1} << block.count) - 1;
  block.intersection = static_cast<std::uint8_t>(all.intersection & used);
  block.unknown = static_cast<std::uint8_t>(all.unknown & used);
  block.signs = all.signs;
}

}  // namespace

void classify_at_this_level(TrianglePairBlock* blocks, std::size_t count, PoseNumbers pose_a, PoseNumbers pose_b) {
  for (TrianglePairBlock* block = blocks; block != blocks + count; ++block)
    classify<Kin::of_two_meshes>(*block, pose_a, pose_b);
}

void classify_neighbours_at_this_level(TrianglePairBlock* blocks, std::size_t count, PoseNumbers pose) {
  for (TrianglePairBlock* block = blocks; block != blocks + count; ++block)
    classify<Kin::of_one_mesh>(*block, pose, pose);
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(classify_at_this_level);
HWY_EXPORT(classify_neighbours_at_this_level);

namespace {

/// The numbers of a pose, unless they are those of no motion, to the bit.
class Numbers {
 public:
  explicit Numbers(const Pose& pose) : numbers_(pose.numbers()), still_(is_still(numbers_)) {}
  [[nodiscard]] PoseNumbers get() const { return still_ ? nullptr : numbers_.data(); }

 private:
  static bool is_still(const std::array<double, 12>& numbers) {
    using Bits = std::array<std::uint64_t, 12>;
    return std::bit_cast<Bits>(numbers) == std::bit_cast<Bits>(Pose{}.numbers());
  }

  std::array<double, 12> numbers_;
  bool still_;
};

}  // namespace

void classify_pairs(const Pose& pose_a, const Pose& pose_b, std::span<TrianglePairBlock> blocks) {
  const Numbers a(pose_a), b(pose_b);
  HWY_DYNAMIC_DISPATCH(classify_at_this_level)(blocks.data(), blocks.size(), a.get(), b.get());
}

void classify_neighbours(const Pose& pose, std::span<TrianglePairBlock> blocks) {
  const Numbers numbers(pose);
  HWY_DYNAMIC_DISPATCH(classify_neighbours_at_this_level)(blocks.data(), blocks.size(), numbers.get());
}

}  // namespace toccata
#endif
