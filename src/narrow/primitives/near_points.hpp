// Near points of two cores by closed formulas, and what is proved of them: docs/design/primitive-distances.md.
// After C. Ericson, "Real-Time Collision Detection", 2005, sections 5.1.2 to 5.1.9; the proofs are ours.
// The formulas are for vectors V, one in each lane, with numbers N and masks M: of many pairs, or of one
// (one_lane.hpp). Included once for every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_NARROW_NEAR_POINTS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_NEAR_POINTS_HPP
#undef TOCCATA_NARROW_NEAR_POINTS_HPP
#else
#define TOCCATA_NARROW_NEAR_POINTS_HPP
#endif

#include <array>

#include "math/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// Points of two cores, one of each but for the slack. In ε = 2^-53 and for d = `apart`:
template <class V>
struct NearPoints {
  V on_a, on_b;
  V apart;              ///< on_a − on_b, closer than their rounded coordinates are
  NumberOf<V> squared;  ///< d · d
  NumberOf<V> spread;   ///< ε · spread is at least what rounding makes of d · (the error of d)
  NumberOf<V> loss;     ///< |d| − loss / |d| is less than the exact distance of the cores, but for the errors above
  NumberOf<V> slack;    ///< the points may be beside the cores, and d off in any direction, by this in all
  MaskOf<V> placed;     ///< the exact nearest points are as near to these as is promised of witnesses
  MaskOf<V> tight;      ///< `loss` is right; else it is only known that the points exist
};

constexpr double greatest_square = 0x1p500;  ///< for products of two squares neither to over- nor to underflow

template <class N>
HWY_INLINE auto is_moderate(const N& squared) {
  return hn::Lt(squared, all<N>(greatest_square));
}

/// Where a share of an edge is to be off from its best value: `slope` is the edge · d, by which d · d / 2 grows.
template <class N>
HWY_INLINE N violation(const N& share, const N& slope) {
  const N zero = hn::Zero(TagOf<N>());
  const N down = hn::IfThenElse(hn::Gt(share, zero), slope, zero);
  const N up = hn::IfThenElse(hn::Lt(share, all<N>(1)), hn::Neg(slope), zero);
  return greater(greater(down, up), zero);
}

/// 64 ε² (|spread|² + 16 d · d), the share of rounding in the square of a residual.
template <class V>
HWY_INLINE NumberOf<V> residual_floor(const V& spread, const NumberOf<V>& squared) {
  using N = NumberOf<V>;
  return hn::Mul(all<N>(0x1p-100), hn::Add(dot(spread, spread), hn::Mul(all<N>(16), squared)));
}

/// At least the length of the error of d. Where d is no longer than that, its spread along d tells nothing.
template <class V>
HWY_INLINE NumberOf<V> length_of_rounding(const V& spread) {
  using N = NumberOf<V>;
  return hn::Mul(all<N>(0x1.01p-53), sum_of(spread));
}

template <class V>
HWY_INLINE NearPoints<V> near_of_points(const V& p, const V& q) {
  using N = NumberOf<V>;
  using M = MaskOf<V>;
  const V d = minus(p, q);
  const N squared = dot(d, d), zero = hn::Zero(TagOf<N>());
  const M yes = hn::Eq(zero, zero);
  return {p, q, d, squared, squared, zero, zero, yes, yes};
}

template <class V>
HWY_INLINE NearPoints<V> near_of_point_segment(const V& p, const V& start, const V& end) {
  using N = NumberOf<V>;
  using M = MaskOf<V>;
  const V edge = minus(end, start), from = minus(p, start);
  const N edge_squared = dot(edge, edge), from_squared = dot(from, from), zero = hn::Zero(TagOf<N>());
  const V step = times(clamped_share(hn::Div(dot(from, edge), edge_squared)), edge);
  const V d = minus(from, step);
  const N squared = dot(d, d);
  const V step_size = magnitudes_of(step);
  const V spread = plus(plus(magnitudes_of(from), plus(step_size, step_size)), magnitudes_of(d));
  const M placed = hn::And(is_moderate(from_squared), is_moderate(edge_squared));
  const M tight = hn::Gt(squared, hn::Mul(all<N>(0x1p-40), from_squared));
  return {p,    plus(start, step),          d,      squared, dot(magnitudes_of(d), spread),
          zero, length_of_rounding(spread), placed, tight};
}

/// One of the two segments as its nearest point sees it.
template <class N>
struct Hold {
  N residual;  ///< 16 violation² / |edge|²
  N slope_squared;
  hn::Mask<TagOf<N>> at_end;  ///< and the slope presses it there
};

template <class N>
HWY_INLINE Hold<N> hold_of(const N& share, const N& slope, const N& inverse_squared) {
  const N wrong = violation(share, slope), zero = hn::Zero(TagOf<N>());
  const auto inside = hn::And(hn::Gt(share, zero), hn::Lt(share, all<N>(1)));
  return {hn::Mul(hn::Mul(all<N>(16), hn::Mul(wrong, wrong)), inverse_squared), hn::Mul(slope, slope),
          hn::And(hn::Not(inside), hn::Eq(wrong, zero))};
}

template <class N>
HWY_INLINE auto is_held(const Hold<N>& hold, const N& residual, const N& edge_squared) {
  return hn::And(hold.at_end, hn::Ge(hold.slope_squared, hn::Mul(residual, edge_squared)));
}

template <class V>
HWY_INLINE NearPoints<V> near_of_segments(const V& p, const V& p_end, const V& r, const V& r_end) {
  using N = NumberOf<V>;
  using M = MaskOf<V>;
  const V u = minus(p_end, p), v = minus(r_end, r), w = minus(p, r);
  const N uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), along_u = dot(u, w), along_v = dot(v, w);
  const N determinant = hn::Sub(hn::Mul(uu, vv), hn::Mul(uv, uv));
  // Divided by at once, for divisions that wait for each other take most of the time.
  const N inverse_u = hn::Div(all<N>(1), hn::Add(uu, all<N>(0x1p-1000))),
          inverse_v = hn::Div(all<N>(1), hn::Add(vv, all<N>(0x1p-1000)));
  const N first_s = clamped_share(hn::Div(hn::Sub(hn::Mul(uv, along_v), hn::Mul(along_u, vv)), determinant));
  const N t = clamped_share(hn::Add(hn::Mul(hn::Mul(uv, inverse_v), first_s), hn::Mul(along_v, inverse_v)));
  const N s = clamped_share(hn::Sub(hn::Mul(hn::Mul(uv, inverse_u), t), hn::Mul(along_u, inverse_u)));
  const V step_u = times(s, u), step_v = times(t, v);
  const V d = minus(plus(w, step_u), step_v);
  const N squared = dot(d, d), zero = hn::Zero(TagOf<N>());
  const V spread = plus(plus(times(all<N>(2), magnitudes_of(w)), times(all<N>(3), magnitudes_of(step_u))),
                        plus(times(all<N>(2), magnitudes_of(step_v)), magnitudes_of(d)));

  const Hold<N> hold_u = hold_of(s, dot(u, d), inverse_u), hold_v = hold_of(t, hn::Neg(dot(v, d)), inverse_v);
  const N residual = hn::Add(hn::Add(hold_u.residual, hold_v.residual), residual_floor(spread, squared));
  const M held = hn::Or(is_held(hold_u, residual, uu), is_held(hold_v, residual, vv));
  // The square of the sine between the two; where one is held at its end, the angle does not matter.
  const N sine = hn::IfThenElse(held, all<N>(1), hn::Mul(hn::Mul(determinant, inverse_u), inverse_v));
  const N size =
      greater(hn::Mul(all<N>(4), dot(p, p)), greater(greater(uu, vv), squared));  // at most 12 · (largest coordinate)²
  const M near_enough = hn::Le(residual, hn::Mul(hn::Mul(all<N>(0x1p-80 / 12), size), hn::Mul(sine, sine)));
  const M loses_little = hn::Le(residual, hn::Mul(all<N>(0x1p-53), hn::Mul(sine, squared)));
  const M plain = hn::And(hn::Gt(sine, all<N>(0x1p-12)), hn::And(is_moderate(uu), is_moderate(vv)));
  return {plus(p, step_u),
          plus(r, step_v),
          d,
          squared,
          dot(magnitudes_of(d), spread),
          zero,
          length_of_rounding(spread),
          hn::And(plain, near_enough),
          loses_little};
}

/// A point of a triangle a + second · ab + third · ac, seen from the origin.
template <class V>
struct Foot {
  V at;
  V spread;  ///< without that of the last sum
  NumberOf<V> second, third;
};

template <class V>
HWY_INLINE Foot<V> select(const MaskOf<V>& mask, const Foot<V>& yes, const Foot<V>& no) {
  return {select(mask, yes.at, no.at), select(mask, yes.spread, no.spread), hn::IfThenElse(mask, yes.second, no.second),
          hn::IfThenElse(mask, yes.third, no.third)};
}

/// The share of the nearest point to the origin of the segment from + [0, 1] · edge.
template <class V>
HWY_INLINE NumberOf<V> nearest_share(const V& from, const V& edge, const NumberOf<V>& edge_squared) {
  return clamped_share(hn::Neg(hn::Div(dot(from, edge), edge_squared)));
}

template <class V>
HWY_INLINE Foot<V> foot_on_edge(const V& from, const V& step, const NumberOf<V>& second, const NumberOf<V>& third) {
  const V size = magnitudes_of(step);
  return {plus(from, step), plus(magnitudes_of(from), plus(size, size)), second, third};
}

template <class V>
struct TriangleEdges {
  V ab, ac, bc;
  NumberOf<V> ab_squared, ac_squared, bc_squared;
};

template <class V>
HWY_INLINE Foot<V> foot_on_edges(const V& a, const V& b, const TriangleEdges<V>& e) {
  using N = NumberOf<V>;
  const N zero = hn::Zero(TagOf<N>());
  const N on_ab = nearest_share(a, e.ab, e.ab_squared), on_ac = nearest_share(a, e.ac, e.ac_squared),
          on_bc = nearest_share(b, e.bc, e.bc_squared);
  const Foot<V> of_ab = foot_on_edge(a, times(on_ab, e.ab), on_ab, zero);
  const Foot<V> of_ac = foot_on_edge(a, times(on_ac, e.ac), zero, on_ac);
  const Foot<V> of_bc = foot_on_edge(b, times(on_bc, e.bc), hn::Sub(all<N>(1), on_bc), on_bc);
  const N to_ab = dot(of_ab.at, of_ab.at), to_ac = dot(of_ac.at, of_ac.at), to_bc = dot(of_bc.at, of_bc.at);
  return select(hn::Lt(lesser(to_ab, to_ac), to_bc), select(hn::Lt(to_ab, to_ac), of_ab, of_ac), of_bc);
}

template <class V>
HWY_INLINE Foot<V> foot_on_face(const V& a, const TriangleEdges<V>& e, const NumberOf<V>& second,
                                const NumberOf<V>& third) {
  using N = NumberOf<V>;
  const V step_b = times(second, e.ab), step_c = times(third, e.ac);
  return {plus(plus(a, step_b), step_c),
          plus(times(all<N>(2), magnitudes_of(a)),
               plus(times(all<N>(3), magnitudes_of(step_b)), times(all<N>(2), magnitudes_of(step_c)))),
          second, third};
}

/// How far the heights of the three corners over the plane through the foot, across d, tell that it is not the nearest:
/// W, the sum of what they are beside 0 where the foot has a share of the corner, and below 0 where it has none.
///
/// The ω that repairs them lies in the triangle's plane, where ω · (corner − foot) is what that height is off by: the
/// gradient of a function with these values at the corners, at most W over the least altitude, and |ω|² at most W² ·
/// longest / area, both squared. With ε = 2^-53, L² = longest and the spread: a slope is off by 4 ε L |d|, the heights
/// made of two slopes by 14 ε L |d|, and for the rounding of d by ε L |spread|; all three heights by a δ with δ² ≤ 9 ·
/// 2 ε² L² (196 |d|² + |spread|²), and (W + δ)² ≤ 2 W² + 2 δ². What is summed up below, 8 W² + 512 ε² L² (|spread|² +
/// 16 |d|²), is more than a quarter of that; so the limits, which are 2^-82 for 2^-80 and 2^-54 for 2^-53, hold with a
/// factor of two or more to spare.
template <class V>
HWY_INLINE NumberOf<V> triangle_violation(const Foot<V>& foot, const NumberOf<V>& slope_b, const NumberOf<V>& slope_c,
                                          const MaskOf<V>& on_face) {
  using N = NumberOf<V>;
  using M = MaskOf<V>;
  const N zero = hn::Zero(TagOf<N>());
  const N of_a = hn::Neg(hn::Add(hn::Mul(foot.second, slope_b), hn::Mul(foot.third, slope_c)));
  const N of_b = hn::Add(slope_b, of_a), of_c = hn::Add(slope_c, of_a);
  // Where an edge's foot is its end, the other end may be higher; of an edge through b and c, a may.
  const N share_a = hn::Sub(hn::Sub(all<N>(1), foot.second), foot.third);
  const auto wrong = [&](const M& used, const N& height) {
    return greater(hn::IfThenElse(used, hn::Abs(height), hn::Neg(height)), zero);
  };
  const M uses_a = hn::Or(on_face, hn::Gt(share_a, zero));
  return hn::Add(hn::Add(wrong(uses_a, of_a), wrong(hn::Gt(foot.second, zero), of_b)),
                 wrong(hn::Gt(foot.third, zero), of_c));
}

template <class V>
HWY_INLINE NearPoints<V> near_of_point_triangle(const V& p, const V& va, const V& vb, const V& vc) {
  using N = NumberOf<V>;
  using M = MaskOf<V>;
  const V a = minus(va, p), b = minus(vb, p);
  TriangleEdges<V> e{minus(vb, va), minus(vc, va), minus(vc, vb), all<N>(0), all<N>(0), all<N>(0)};
  e.ab_squared = dot(e.ab, e.ab);
  e.ac_squared = dot(e.ac, e.ac);
  e.bc_squared = dot(e.bc, e.bc);
  const V normal = cross(e.ab, e.ac);
  const N area = dot(normal, normal), zero = hn::Zero(TagOf<N>());
  const N of_b = dot(cross(e.ac, a), normal), of_c = dot(cross(a, e.ab), normal);
  const M on_face = hn::And(hn::Gt(lesser(of_b, of_c), zero), hn::Lt(hn::Add(of_b, of_c), area));
  const N inverse = hn::Div(all<N>(1), area);
  const N second = clamped_share(hn::Mul(of_b, inverse));
  const N third = clamped_between(hn::Mul(of_c, inverse), zero, hn::Sub(all<N>(1), second));
  const Foot<V> foot = select(on_face, foot_on_face(a, e, second, third), foot_on_edges(a, b, e));

  const V& d = foot.at;
  const V spread = plus(foot.spread, magnitudes_of(d));
  const N squared = dot(d, d);
  const N wrong = triangle_violation(foot, dot(e.ab, d), dot(e.ac, d), on_face);
  const N longest = greater(greater(e.ab_squared, e.ac_squared), e.bc_squared);
  const N rounding = hn::Mul(all<N>(8), hn::Mul(longest, residual_floor(spread, squared)));
  const N residual = hn::Mul(longest, hn::Add(hn::Mul(all<N>(8), hn::Mul(wrong, wrong)), rounding));
  const N size =
      greater(hn::Mul(all<N>(4), dot(p, p)), greater(longest, squared));  // at most 12 · (largest coordinate)²
  const M near_enough = hn::Le(residual, hn::Mul(hn::Mul(all<N>(0x1p-82 / 12), size), area));
  const M loses_little = hn::Le(residual, hn::Mul(all<N>(0x1p-54), hn::Mul(squared, area)));
  const M plain = hn::And(hn::Gt(area, hn::Mul(all<N>(0x1p-60), hn::Mul(longest, longest))), is_moderate(longest));
  return {p,
          plus(p, d),
          negative(d),
          squared,
          dot(magnitudes_of(d), spread),
          zero,
          length_of_rounding(spread),
          hn::And(plain, near_enough),
          loses_little};
}

/// The corners of a box, and from which of them the nearest point is seen.
template <class V>
using BoxVertices = std::array<V, 8>;

template <class V>
struct BoxSides {
  std::array<NumberOf<V>, 3> squared;  ///< of the edges from corner 0, which stand for those across
  std::array<NumberOf<V>, 3> inverse_squared;
  std::array<MaskOf<V>, 3> far;  ///< the nearest point is beyond the middle of the edge from corner 0
};

template <class V>
HWY_INLINE BoxSides<V> sides_of(const V& p, const V& origin, const std::array<V, 3>& neighbour) {
  using N = NumberOf<V>;
  BoxSides<V> sides;
  const V from = minus(p, origin);
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    const V edge = minus(neighbour[k], origin);
    sides.squared[k] = dot(edge, edge);
    sides.inverse_squared[k] = hn::Div(all<N>(1), sides.squared[k]);
    sides.far[k] = hn::Gt(dot(from, edge), hn::Mul(all<N>(0.5), sides.squared[k]));
  }
  return sides;
}

/// What the corners but the first and its neighbours add to the proof for a box.
///
/// A height is off by 4 ε of the sum of its magnitudes: the difference of corners, the product and two sums are
/// rounded. Second orders, and the rounding of the height less its error, are below 2^-8 ε |d|² where an interval turns
/// out narrow: 4 ε of the magnitudes are then below 10^-12 |d|², and so are the heights; `reached` has half an ε |d|²
/// to spare.
///
/// A corner's bend b is c_i − (c_0 + its edges), |b| ≤ β. Let K be the hull of the corners, K' the parallelepiped of
/// the first four, y and y' their points nearest to p, d = y' − p. y = Σ w_i c_i = x + b with x in K', |b| ≤ β. Moving
/// weight along edges turns x into y' and changes Σ w_i b_i by at most 2β Σ |x − y'| · 1.1 / |e_k| = 2.2 β S |x − y'|;
/// so as y is no farther from p than that point of K, and |x − p|² ≥ |d|² + |x − y'|²,
///   |x − y'|² ≤ 2 (2.2 β S |x − y'|) (|d| + β) + 2 β |x − y'|, and |y − y'| ≤ 3 β + 4.4 β S (|d| + β).
/// With S² ≤ 3 Σ 1 / |e_k|² the square is at most 18 β² + 117 β² |d|² Σ 1 / |e_k|² but for higher powers of β.
template <class V>
struct BoxRest {
  NumberOf<V> lowest;  ///< the least height along d over the first corner, less what it may be off by
  NumberOf<V> bend;    ///< how far corners are from the parallelepiped of the first four, but for rounding
};

template <class V>
HWY_INLINE NumberOf<V> certain_height(const V& from_first, const V& d, const V& size_of_d) {
  using N = NumberOf<V>;
  return hn::Sub(dot(from_first, d), hn::Mul(all<N>(0x1p-51), dot(magnitudes_of(from_first), size_of_d)));
}

/// The nearest corner, and the three edges that leave it.
template <class V>
struct BoxCorner {
  V at;
  std::array<V, 3> edge;
};

template <class V>
HWY_INLINE BoxRest<V> rest_of_box(const BoxVertices<V>& c, const std::array<V, 3>& edge, const V& d) {
  using N = NumberOf<V>;
  BoxRest<V> rest{hn::Zero(TagOf<N>()), hn::Zero(TagOf<N>())};
  const V size_of_d = magnitudes_of(d);
  for (const V& e : edge) rest.lowest = lesser(rest.lowest, certain_height(e, d, size_of_d));
  for (const std::size_t i : {std::size_t{3}, std::size_t{5}, std::size_t{6}, std::size_t{7}}) {
    const V from_first = minus(c[i], c[0]);
    rest.lowest = lesser(rest.lowest, certain_height(from_first, d, size_of_d));
    V bent = from_first;
    for (std::size_t k = 0; k < 3; ++k)
      if ((i >> k & 1) != 0) bent = minus(bent, edge[k]);
    const V size = magnitudes_of(bent);
    rest.bend = greater(rest.bend, sum_of(size));
  }
  return rest;
}

/// `rest_along(d)` gives the rest.
template <class V, class RestAlong>
HWY_INLINE NearPoints<V> near_of_point_corner(const V& p, const BoxCorner<V>& corner, const BoxSides<V>& sides,
                                              const RestAlong& rest_along) {
  using N = NumberOf<V>;
  using M = MaskOf<V>;
  const N zero = hn::Zero(TagOf<N>());
  const std::array<N, 3>& inverse_squared = sides.inverse_squared;
  const std::array<V, 3>& edge = corner.edge;
  const V from = minus(corner.at, p);
  std::array<N, 3> share;
  std::array<V, 3> step;
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    share[k] = clamped_between(hn::Neg(hn::Mul(dot(from, edge[k]), inverse_squared[k])), zero, all<N>(0.5));
    step[k] = times(share[k], edge[k]);
  }
  const V steps = plus(plus(step[0], step[1]), step[2]), d = plus(from, steps);
  const N squared = dot(d, d);
  const V step_sizes = plus(plus(magnitudes_of(step[0]), magnitudes_of(step[1])), magnitudes_of(step[2]));
  const V spread = plus(plus(magnitudes_of(from), times(all<N>(4), step_sizes)), magnitudes_of(d));

  const BoxRest<V> rest = rest_along(d);
  N drift = zero, residual = zero, size = greater(hn::Mul(all<N>(4), dot(p, p)), squared), inverses = zero;
  M free = hn::Eq(zero, zero);
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    const N slope = dot(edge[k], d);
    const M inner = hn::Gt(share[k], zero);
    const N wrong = hn::IfThenElse(inner, slope, lesser(slope, zero));
    residual = hn::Add(residual, hn::Mul(hn::Mul(wrong, wrong), inverse_squared[k]));
    drift = hn::Add(drift, hn::Mul(share[k], hn::Abs(slope)));
    size = greater(size, sides.squared[k]);
    inverses = hn::Add(inverses, inverse_squared[k]);
    free = hn::And(free, inner);
  }
  const N x = dot(edge[0], edge[1]), y = dot(edge[1], edge[2]), z = dot(edge[2], edge[0]);
  const N skew = hn::Add(hn::Add(hn::Mul(hn::Mul(x, x), hn::Mul(inverse_squared[0], inverse_squared[1])),
                                 hn::Mul(hn::Mul(y, y), hn::Mul(inverse_squared[1], inverse_squared[2]))),
                         hn::Mul(hn::Mul(z, z), hn::Mul(inverse_squared[2], inverse_squared[0])));
  // Made of differences of corners and edges, the bend is off by 4 ε of the edges' magnitudes.
  const N edge_sizes = sum_of(plus(plus(magnitudes_of(edge[0]), magnitudes_of(edge[1])), magnitudes_of(edge[2])));
  const N bend = hn::Add(rest.bend, hn::Mul(all<N>(0x1.1p-51), edge_sizes)), bend_squared = hn::Mul(bend, bend);
  const N bent =
      hn::Mul(hn::Mul(all<N>(32), bend_squared), hn::Add(all<N>(1), hn::Mul(all<N>(4), hn::Mul(squared, inverses))));
  const N floor = residual_floor(spread, squared);
  const N all_residual = hn::Add(hn::Mul(all<N>(16), residual), hn::Add(floor, bent));
  const M near_enough = hn::Le(all_residual, hn::Mul(all<N>(0x1p-81 / 12), size));
  const M like_a_box = hn::Le(hn::Add(skew, hn::Mul(bend_squared, inverses)), all<N>(0x1p-12));
  // Within the box the point is its own nearest one, but for rounding.
  const M within = hn::Le(hn::Add(squared, bend_squared), hn::Mul(all<N>(0x1p-90), size));
  const M beside = hn::And(hn::Not(free), hn::And(near_enough, like_a_box));
  // What d is off by across itself is of second order then.
  const M long_enough = hn::Le(floor, hn::Mul(all<N>(0x1p-50), squared));
  const N drift_error = hn::Mul(all<N>(0x1p-51), dot(step_sizes, magnitudes_of(d)));
  return {p,
          plus(p, d),
          negative(d),
          squared,
          dot(magnitudes_of(d), spread),
          hn::Sub(hn::Add(drift, drift_error), rest.lowest),
          hn::Add(bend, length_of_rounding(spread)),
          hn::And(is_moderate(size), hn::Or(within, beside)),
          hn::And(hn::Not(free), long_enough)};
}

/// The corners are numbered from the one nearest to p, which is corner 0.
template <class V>
HWY_INLINE NearPoints<V> near_of_point_corners(const V& p, const BoxVertices<V>& c, const BoxSides<V>& sides) {
  const BoxCorner<V> corner{c[0], {minus(c[1], c[0]), minus(c[2], c[0]), minus(c[4], c[0])}};
  return near_of_point_corner(p, corner, sides, [&](const V& d) { return rest_of_box(c, corner.edge, d); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
