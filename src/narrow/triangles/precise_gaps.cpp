// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/triangles/precise_gaps.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <array>

#include "math/lanes.hpp"
#include "narrow/triangles/triangle_gaps.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

// The numbers of math/double_word.hpp, one in each lane, by the same operations. Products are split as there at every
// level, for a fused one is not the same where parts underflow.

struct TwoNumbers {
  Number high, low;
};

HWY_INLINE TwoNumbers two_sum(const Number& a, const Number& b) {
  const Number high = hn::Add(a, b);
  const Number b_part = hn::Sub(high, a), a_part = hn::Sub(high, b_part);
  return {high, hn::Add(hn::Sub(a, a_part), hn::Sub(b, b_part))};
}
HWY_INLINE TwoNumbers fast_two_sum(const Number& a, const Number& b) {
  const Number high = hn::Add(a, b);
  return {high, hn::Sub(b, hn::Sub(high, a))};
}
HWY_INLINE TwoNumbers split(const Number& a) {
  const Number scaled = hn::Mul(all(0x1.0000002p27), a);
  const Number high = hn::Sub(scaled, hn::Sub(scaled, a));
  return {high, hn::Sub(a, high)};
}
HWY_INLINE TwoNumbers two_product(const Number& a, const Number& b) {
  const Number high = hn::Mul(a, b);
  const TwoNumbers x = split(a), y = split(b);
  const Number rest =
      hn::Sub(hn::Sub(hn::Sub(high, hn::Mul(x.high, y.high)), hn::Mul(x.low, y.high)), hn::Mul(x.high, y.low));
  return {high, hn::Sub(hn::Mul(x.low, y.low), rest)};
}

HWY_INLINE TwoNumbers plus(const TwoNumbers& a, const TwoNumbers& b) {
  const TwoNumbers high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const TwoNumbers carried = fast_two_sum(high.high, hn::Add(high.low, low.high));
  return fast_two_sum(carried.high, hn::Add(low.low, carried.low));
}
HWY_INLINE TwoNumbers minus(const TwoNumbers& a, const TwoNumbers& b) {
  return plus(a, {hn::Neg(b.high), hn::Neg(b.low)});
}
HWY_INLINE TwoNumbers times(const TwoNumbers& a, const TwoNumbers& b) {
  const TwoNumbers product = two_product(a.high, b.high);
  const Number across = hn::Add(hn::Mul(a.high, b.low), hn::Mul(a.low, b.high));
  return fast_two_sum(product.high, hn::Add(product.low, across));
}
HWY_INLINE TwoNumbers times(const TwoNumbers& a, const Number& b) {
  const TwoNumbers product = two_product(a.high, b);
  const TwoNumbers high = fast_two_sum(product.high, hn::Mul(a.low, b));
  return fast_two_sum(high.high, hn::Add(high.low, product.low));
}
HWY_INLINE Mask is_less(const TwoNumbers& a, const TwoNumbers& b) {
  return hn::Or(hn::Lt(a.high, b.high), hn::And(hn::Eq(a.high, b.high), hn::Lt(a.low, b.low)));
}
HWY_INLINE TwoNumbers select(const Mask& mask, const TwoNumbers& yes, const TwoNumbers& no) {
  return {hn::IfThenElse(mask, yes.high, no.high), hn::IfThenElse(mask, yes.low, no.low)};
}

struct PreciseVector {
  TwoNumbers x, y, z;
};

HWY_INLINE PreciseVector precise_difference(const Vector& a, const Vector& b) {
  const Vector away = negative(b);
  return {two_sum(a.x, away.x), two_sum(a.y, away.y), two_sum(a.z, away.z)};
}
HWY_INLINE PreciseVector moved(const PreciseVector& from, const Number& share, const PreciseVector& along) {
  return {plus(from.x, times(along.x, share)), plus(from.y, times(along.y, share)),
          plus(from.z, times(along.z, share))};
}
HWY_INLINE TwoNumbers dot(const PreciseVector& u, const PreciseVector& v) {
  return plus(plus(times(u.x, v.x), times(u.y, v.y)), times(u.z, v.z));
}
HWY_INLINE Vector high_parts(const PreciseVector& v) { return {v.x.high, v.y.high, v.z.high}; }

using TriangleVertices = std::array<Vector, 3>;

HWY_INLINE TriangleVertices corners_in(const TrianglePairBlock::Corners& corners, std::size_t lane) {
  const auto at = [&](std::size_t i) -> Vector {
    return {hn::Load(tag, corners[i][0].data() + lane), hn::Load(tag, corners[i][1].data() + lane),
            hn::Load(tag, corners[i][2].data() + lane)};
  };
  return {at(0), at(1), at(2)};
}

/// One of three.
struct Choice {
  Mask second, third;

  HWY_INLINE Vector of(const Vector& a, const Vector& b, const Vector& c) const {
    return select(third, c, select(second, b, a));
  }
};

/// Differences from points of b to points of a: start + s · along + t · other_along, for shares within a square or,
/// where a face is one of the features, a triangle.
struct Differences {
  PreciseVector start, along, other_along;
  Mask of_face;
};

HWY_INLINE Differences differences(const TriangleVertices& a, const TriangleVertices& b, const Number& features) {
  const auto is = [&](double number) { return hn::Eq(features, all(number)); };
  const auto is_from = [&](double first, double last) {
    return hn::And(hn::Ge(features, all(first)), hn::Le(features, all(last)));
  };
  // The vertex of a: where an edge begins, or above a face. The first where the feature is a's face; so of b.
  const Choice of_a{hn::Or(is_from(3, 5), is(10)), hn::Or(is_from(6, 8), is(11))};
  const Choice of_b{hn::Or(hn::Or(is(1), is(4)), hn::Or(is(7), is(13))),
                    hn::Or(hn::Or(is(2), is(5)), hn::Or(is(8), is(14)))};
  // Two edges, the face of b, or that of a.
  const Choice kind{is_from(9, 11), is_from(12, 14)};
  const Vector at_a = of_a.of(a[0], a[1], a[2]), after_a = of_a.of(a[1], a[2], a[0]);
  const Vector at_b = of_b.of(b[0], b[1], b[2]), after_b = of_b.of(b[1], b[2], b[0]);
  return {precise_difference(at_a, at_b), precise_difference(kind.of(after_a, b[0], a[1]), kind.of(at_a, b[1], a[0])),
          precise_difference(kind.of(at_b, b[0], a[2]), kind.of(after_b, b[2], a[0])), is_from(9, 14)};
}

/// Two shares, each the sum of two doubles.
struct PreciseShares {
  Number s, t, more_s, more_t;
};

/// Well within what is allowed, or at an end of it and not moved.
HWY_INLINE Mask fits(const Number& share, const Number& more) {
  const Number zero = hn::Zero(tag), moved_to = hn::Add(share, more);
  const Mask inside = hn::And(hn::Gt(moved_to, all(0x1p-50)), hn::Lt(moved_to, all(1 - 0x1p-50)));
  const Mask as_it_was = hn::And(hn::Ge(share, zero), hn::Le(share, all(1)));
  return hn::Or(hn::And(hn::Eq(more, zero), as_it_was), hn::AndNot(hn::Eq(more, zero), inside));
}
HWY_INLINE Mask are_allowed(const PreciseShares& at, const Mask& of_face) {
  const Number sum = hn::Add(hn::Add(at.s, at.more_s), hn::Add(at.t, at.more_t));
  return hn::And(hn::And(fits(at.s, at.more_s), fits(at.t, at.more_t)),
                 hn::Or(hn::Not(of_face), hn::Lt(sum, all(1 - 0x1p-50))));
}

/// Two shares on the way to the least difference, and this.
struct ReachedDifference {
  PreciseShares at;
  PreciseVector difference;
};

HWY_INLINE ReachedDifference start_of(const Differences& d, const Number& s, const Number& t) {
  return {{s, t, hn::Zero(tag), hn::Zero(tag)}, moved(moved(d.start, s, d.along), t, d.other_along)};
}

/// After a step of Newton's, of the shares that are not at an end.
HWY_INLINE ReachedDifference stepped(const Differences& d, const ReachedDifference& from) {
  const Number down = dot(from.difference, d.along).high, other_down = dot(from.difference, d.other_along).high;
  const Vector u = high_parts(d.along), v = high_parts(d.other_along);
  const Number uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), zero = hn::Zero(tag);
  const Number area = hn::Sub(hn::Mul(uu, vv), hn::Mul(uv, uv));
  const Mask free = hn::And(hn::Gt(from.at.s, zero), hn::Lt(from.at.s, all(1)));
  const Mask other_free = hn::And(hn::Gt(from.at.t, zero), hn::Lt(from.at.t, all(1)));
  const Number both_s = hn::Div(hn::Sub(hn::Mul(uv, other_down), hn::Mul(vv, down)), area);
  const Number both_t = hn::Div(hn::Sub(hn::Mul(uv, down), hn::Mul(uu, other_down)), area);
  const Number one_s = hn::Div(hn::Neg(down), uu), one_t = hn::Div(hn::Neg(other_down), vv);
  const Number by_s = hn::IfThenElseZero(free, hn::IfThenElse(other_free, both_s, one_s));
  const Number by_t = hn::IfThenElseZero(other_free, hn::IfThenElse(free, both_t, one_t));
  return {{from.at.s, from.at.t, hn::Add(from.at.more_s, by_s), hn::Add(from.at.more_t, by_t)},
          moved(moved(from.difference, by_s, d.along), by_t, d.other_along)};
}

/// How far apart the triangles are along a difference, times its length.
HWY_INLINE TwoNumbers height(const PreciseVector& along, const TriangleVertices& a, const TriangleVertices& b) {
  const Vector& origin = b[0];
  TwoNumbers least = dot(along, precise_difference(a[0], origin)), greatest{hn::Zero(tag), hn::Zero(tag)};
  for (std::size_t i = 1; i < 3; ++i) {
    const TwoNumbers of_a = dot(along, precise_difference(a[i], origin));
    const TwoNumbers of_b = dot(along, precise_difference(b[i], origin));
    least = select(is_less(of_a, least), of_a, least);
    greatest = select(is_less(greatest, of_b), of_b, greatest);
  }
  return minus(least, greatest);
}

HWY_INLINE Number largest_difference(const TriangleVertices& a, const TriangleVertices& b) {
  Number largest = hn::Zero(tag);
  for (std::size_t i = 0; i < 3; ++i)
    for (const Vector& v : {minus(a[i], b[0]), minus(b[i], b[0])})
      largest = greater(greater(greater(largest, hn::Abs(v.x)), hn::Abs(v.y)), hn::Abs(v.z));
  return largest;
}

struct GapEnds {
  Number lower, upper;

  /// They tell something, but not enough: the step before did not come near enough to the least difference.
  HWY_INLINE Mask are_wide() const {
    return hn::And(hn::Lt(upper, hn::Inf(tag)), hn::Gt(hn::Sub(upper, lower), hn::Mul(all(0x1p-42), upper)));
  }
};

// Bounds: docs/methods/mesh-distance.md.
HWY_INLINE GapEnds ends_of(const TriangleVertices& a, const TriangleVertices& b, const Mask& of_face,
                           const ReachedDifference& reached) {
  const PreciseVector& least = reached.difference;
  const Number size = largest_difference(a, b), off = hn::Mul(all(0x1p-90), size), zero = hn::Zero(tag);
  const Number length = hn::Sqrt(dot(least, least).high), lower = hn::Div(height(least, a, b).high, length);
  const Mask plain = hn::And(hn::And(hn::Gt(size, all(0x1p-200)), hn::Lt(size, all(0x1p200))),
                             hn::Gt(length, hn::Mul(all(0x1p-60), size)));
  const Mask known = hn::And(plain, are_allowed(reached.at, of_face));
  const Number at_least = greater(hn::Sub(hn::Mul(lower, all(1 - 0x1p-49)), off), zero);
  const Number at_most = hn::Add(hn::Mul(length, all(1 + 0x1p-49)), off);
  return {hn::IfThenElseZero(known, at_least), hn::IfThenElse(known, at_most, hn::Inf(tag))};
}

HWY_INLINE void refine_lanes(const TrianglePairBlock& block, std::size_t lane, TriangleGaps& gaps) {
  const TriangleVertices a = corners_in(block.a, lane), b = corners_in(block.b, lane);
  const Differences d = differences(a, b, hn::Load(tag, gaps.features.data() + lane));
  const Number s = hn::Load(tag, gaps.share.data() + lane), t = hn::Load(tag, gaps.other_share.data() + lane);
  const ReachedDifference once = stepped(d, start_of(d, s, t));
  GapEnds ends = ends_of(a, b, d.of_face, once);
  const Mask wide = ends.are_wide();
  if (!hn::AllFalse(tag, wide)) {
    // Only in the lanes that need it, so that none depends on its neighbours.
    const GapEnds again = ends_of(a, b, d.of_face, stepped(d, once));
    ends = {hn::IfThenElse(wide, again.lower, ends.lower), hn::IfThenElse(wide, again.upper, ends.upper)};
  }
  hn::Store(ends.lower, tag, gaps.lower.data() + lane);
  hn::Store(ends.upper, tag, gaps.upper.data() + lane);
}

}  // namespace

void refine_gaps_at_this_level(const TrianglePairBlock& block, TriangleGaps& gaps) {
  for (std::size_t lane = 0; lane < TrianglePairBlock::lanes; lane += hn::Lanes(tag)) refine_lanes(block, lane, gaps);
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(refine_gaps_at_this_level);

void refine_gaps(const TrianglePairBlock& block, TriangleGaps& gaps) {
  HWY_DYNAMIC_DISPATCH(refine_gaps_at_this_level)(block, gaps);
}

}  // namespace toccata
#endif
