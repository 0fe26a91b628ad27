// Near points of two cores by closed formulas, and what is proved of them: docs/design/primitive-distances.md.
// After C. Ericson, "Real-Time Collision Detection", 2005, sections 5.1.2 to 5.1.9; the proofs are ours.
// Included once for every SIMD level (lanes.hpp).
#if defined(TOCCATA_NARROW_NEAR_POINTS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_NEAR_POINTS_HPP
#undef TOCCATA_NARROW_NEAR_POINTS_HPP
#else
#define TOCCATA_NARROW_NEAR_POINTS_HPP
#endif

#include <array>

#include "narrow/triangles/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// Points of two cores, one of each but for the slack. In ε = 2^-53 and for d = `apart`:
struct NearPoints {
  Vector on_a, on_b;
  Vector apart;    ///< on_a − on_b, closer than their rounded coordinates are
  Number squared;  ///< d · d
  Number spread;   ///< ε · spread is at least what rounding makes of d · (the error of d)
  Number loss;     ///< |d| − loss / |d| is less than the exact distance of the cores, but for the errors above
  Number slack;    ///< the points may be beside the cores, and d off in any direction, by this in all
  Mask placed;     ///< the exact nearest points are as near to these as is promised of witnesses
  Mask tight;      ///< `loss` is right; else it is only known that the points exist
};

constexpr double greatest_square = 0x1p500;  ///< for products of two squares neither to over- nor to underflow

HWY_INLINE Mask is_moderate(const Number& squared) { return hn::Lt(squared, all(greatest_square)); }

/// Where a share of an edge is to be off from its best value: `slope` is the edge · d, by which d · d / 2 grows.
HWY_INLINE Number violation(const Number& share, const Number& slope) {
  const Number zero = hn::Zero(Tag());
  const Number down = hn::IfThenElse(hn::Gt(share, zero), slope, zero);
  const Number up = hn::IfThenElse(hn::Lt(share, all(1)), hn::Neg(slope), zero);
  return greater(greater(down, up), zero);
}

/// 64 ε² (|spread|² + 16 d · d), the share of rounding in the square of a residual.
HWY_INLINE Number residual_floor(const Vector& spread, const Number& squared) {
  return hn::Mul(all(0x1p-100), hn::Add(dot(spread, spread), hn::Mul(all(16), squared)));
}

/// At least the length of the error of d. Where d is no longer than that, its spread along d tells nothing.
HWY_INLINE Number length_of_rounding(const Vector& spread) { return hn::Mul(all(0x1.01p-53), sum_of(spread)); }

HWY_INLINE NearPoints near_of_points(const Vector& p, const Vector& q) {
  const Vector d = minus(p, q);
  const Number squared = dot(d, d), zero = hn::Zero(Tag());
  const Mask yes = hn::Eq(zero, zero);
  return {p, q, d, squared, squared, zero, zero, yes, yes};
}

HWY_INLINE NearPoints near_of_point_segment(const Vector& p, const Vector& start, const Vector& end) {
  const Vector edge = minus(end, start), from = minus(p, start);
  const Number edge_squared = dot(edge, edge), from_squared = dot(from, from), zero = hn::Zero(Tag());
  const Vector step = times(clamped_share(hn::Div(dot(from, edge), edge_squared)), edge);
  const Vector d = minus(from, step);
  const Number squared = dot(d, d);
  const Vector step_size = magnitudes_of(step);
  const Vector spread = plus(plus(magnitudes_of(from), plus(step_size, step_size)), magnitudes_of(d));
  const Mask placed = hn::And(is_moderate(from_squared), is_moderate(edge_squared));
  const Mask tight = hn::Gt(squared, hn::Mul(all(0x1p-40), from_squared));
  return {p,    plus(start, step),          d,      squared, dot(magnitudes_of(d), spread),
          zero, length_of_rounding(spread), placed, tight};
}

/// One of the two segments as its nearest point sees it.
struct Hold {
  Number residual;  ///< 16 violation² / |edge|²
  Number slope_squared;
  Mask at_end;  ///< and the slope presses it there
};

HWY_INLINE Hold hold_of(const Number& share, const Number& slope, const Number& inverse_squared) {
  const Number wrong = violation(share, slope), zero = hn::Zero(Tag());
  const Mask inside = hn::And(hn::Gt(share, zero), hn::Lt(share, all(1)));
  return {hn::Mul(hn::Mul(all(16), hn::Mul(wrong, wrong)), inverse_squared), hn::Mul(slope, slope),
          hn::And(hn::Not(inside), hn::Eq(wrong, zero))};
}

HWY_INLINE Mask is_held(const Hold& hold, const Number& residual, const Number& edge_squared) {
  return hn::And(hold.at_end, hn::Ge(hold.slope_squared, hn::Mul(residual, edge_squared)));
}

HWY_INLINE NearPoints near_of_segments(const Vector& p, const Vector& p_end, const Vector& r, const Vector& r_end) {
  const Vector u = minus(p_end, p), v = minus(r_end, r), w = minus(p, r);
  const Number uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), along_u = dot(u, w), along_v = dot(v, w);
  const Number determinant = hn::Sub(hn::Mul(uu, vv), hn::Mul(uv, uv));
  // Divided by at once, for divisions that wait for each other take most of the time.
  const Number inverse_u = hn::Div(all(1), hn::Add(uu, all(0x1p-1000))),
               inverse_v = hn::Div(all(1), hn::Add(vv, all(0x1p-1000)));
  const Number first_s = clamped_share(hn::Div(hn::Sub(hn::Mul(uv, along_v), hn::Mul(along_u, vv)), determinant));
  const Number t = clamped_share(hn::Add(hn::Mul(hn::Mul(uv, inverse_v), first_s), hn::Mul(along_v, inverse_v)));
  const Number s = clamped_share(hn::Sub(hn::Mul(hn::Mul(uv, inverse_u), t), hn::Mul(along_u, inverse_u)));
  const Vector step_u = times(s, u), step_v = times(t, v);
  const Vector d = minus(plus(w, step_u), step_v);
  const Number squared = dot(d, d), zero = hn::Zero(Tag());
  const Vector spread = plus(plus(times(all(2), magnitudes_of(w)), times(all(3), magnitudes_of(step_u))),
                             plus(times(all(2), magnitudes_of(step_v)), magnitudes_of(d)));

  const Hold hold_u = hold_of(s, dot(u, d), inverse_u), hold_v = hold_of(t, hn::Neg(dot(v, d)), inverse_v);
  const Number residual = hn::Add(hn::Add(hold_u.residual, hold_v.residual), residual_floor(spread, squared));
  const Mask held = hn::Or(is_held(hold_u, residual, uu), is_held(hold_v, residual, vv));
  // The square of the sine between the two; where one is held at its end, the angle does not matter.
  const Number sine = hn::IfThenElse(held, all(1), hn::Mul(hn::Mul(determinant, inverse_u), inverse_v));
  const Number size =
      greater(hn::Mul(all(4), dot(p, p)), greater(greater(uu, vv), squared));  // at most 12 · (largest coordinate)²
  const Mask near_enough = hn::Le(residual, hn::Mul(hn::Mul(all(0x1p-80 / 12), size), hn::Mul(sine, sine)));
  const Mask loses_little = hn::Le(residual, hn::Mul(all(0x1p-53), hn::Mul(sine, squared)));
  const Mask plain = hn::And(hn::Gt(sine, all(0x1p-12)), hn::And(is_moderate(uu), is_moderate(vv)));
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
struct Foot {
  Vector at;
  Vector spread;  ///< without that of the last sum
  Number second, third;
};

HWY_INLINE Foot select(const Mask& mask, const Foot& yes, const Foot& no) {
  return {select(mask, yes.at, no.at), select(mask, yes.spread, no.spread), hn::IfThenElse(mask, yes.second, no.second),
          hn::IfThenElse(mask, yes.third, no.third)};
}

/// The share of the nearest point to the origin of the segment from + [0, 1] · edge.
HWY_INLINE Number nearest_share(const Vector& from, const Vector& edge, const Number& edge_squared) {
  return clamped_share(hn::Neg(hn::Div(dot(from, edge), edge_squared)));
}

HWY_INLINE Foot foot_on_edge(const Vector& from, const Vector& step, const Number& second, const Number& third) {
  const Vector size = magnitudes_of(step);
  return {plus(from, step), plus(magnitudes_of(from), plus(size, size)), second, third};
}

struct TriangleEdges {
  Vector ab, ac, bc;
  Number ab_squared, ac_squared, bc_squared;
};

HWY_INLINE Foot foot_on_edges(const Vector& a, const Vector& b, const TriangleEdges& e) {
  const Number zero = hn::Zero(Tag());
  const Number on_ab = nearest_share(a, e.ab, e.ab_squared), on_ac = nearest_share(a, e.ac, e.ac_squared),
               on_bc = nearest_share(b, e.bc, e.bc_squared);
  const Foot of_ab = foot_on_edge(a, times(on_ab, e.ab), on_ab, zero);
  const Foot of_ac = foot_on_edge(a, times(on_ac, e.ac), zero, on_ac);
  const Foot of_bc = foot_on_edge(b, times(on_bc, e.bc), hn::Sub(all(1), on_bc), on_bc);
  const Number to_ab = dot(of_ab.at, of_ab.at), to_ac = dot(of_ac.at, of_ac.at), to_bc = dot(of_bc.at, of_bc.at);
  return select(hn::Lt(lesser(to_ab, to_ac), to_bc), select(hn::Lt(to_ab, to_ac), of_ab, of_ac), of_bc);
}

HWY_INLINE Foot foot_on_face(const Vector& a, const TriangleEdges& e, const Number& second, const Number& third) {
  const Vector step_b = times(second, e.ab), step_c = times(third, e.ac);
  return {plus(plus(a, step_b), step_c),
          plus(times(all(2), magnitudes_of(a)),
               plus(times(all(3), magnitudes_of(step_b)), times(all(2), magnitudes_of(step_c)))),
          second, third};
}

/// How far the heights of the three corners over the plane through the foot, across d, tell that it is not the nearest:
/// W, the sum of what they are beside 0 where the foot has a share of the corner, and below 0 where it has none.
///
/// The ω that repairs them lies in the triangle's plane, where ω · (corner − foot) is what that height is off by: the
/// gradient of a function with these values at the corners, at most W over the least altitude, and |ω|² at most
/// W² · longest / area, both squared. Of ε = 2^-53, L² = longest and spread: a slope is off by 4 ε L |d|, the heights
/// made of two slopes by 14 ε L |d|, and for the rounding of d by ε L |spread|; all three heights by a δ with
/// δ² ≤ 9 · 2 ε² L² (196 |d|² + |spread|²), and (W + δ)² ≤ 2 W² + 2 δ². What is summed up below, 8 W² + 512 ε² L²
/// (|spread|² + 16 |d|²), is more than a quarter of that; so the limits, which are 2^-82 for 2^-80 and 2^-54 for 2^-53,
/// hold with a factor of two or more to spare.
HWY_INLINE Number triangle_violation(const Foot& foot, const Number& slope_b, const Number& slope_c,
                                     const Mask& on_face) {
  const Number zero = hn::Zero(Tag());
  const Number of_a = hn::Neg(hn::Add(hn::Mul(foot.second, slope_b), hn::Mul(foot.third, slope_c)));
  const Number of_b = hn::Add(slope_b, of_a), of_c = hn::Add(slope_c, of_a);
  // Where an edge's foot is its end, the other end may be higher; of an edge through b and c, a may.
  const Number share_a = hn::Sub(hn::Sub(all(1), foot.second), foot.third);
  const auto wrong = [&](const Mask& used, const Number& height) {
    return greater(hn::IfThenElse(used, hn::Abs(height), hn::Neg(height)), zero);
  };
  const Mask uses_a = hn::Or(on_face, hn::Gt(share_a, zero));
  return hn::Add(hn::Add(wrong(uses_a, of_a), wrong(hn::Gt(foot.second, zero), of_b)),
                 wrong(hn::Gt(foot.third, zero), of_c));
}

HWY_INLINE NearPoints near_of_point_triangle(const Vector& p, const Vector& va, const Vector& vb, const Vector& vc) {
  const Vector a = minus(va, p), b = minus(vb, p);
  TriangleEdges e{minus(vb, va), minus(vc, va), minus(vc, vb), all(0), all(0), all(0)};
  e.ab_squared = dot(e.ab, e.ab);
  e.ac_squared = dot(e.ac, e.ac);
  e.bc_squared = dot(e.bc, e.bc);
  const Vector normal = cross(e.ab, e.ac);
  const Number area = dot(normal, normal), zero = hn::Zero(Tag());
  const Number of_b = dot(cross(e.ac, a), normal), of_c = dot(cross(a, e.ab), normal);
  const Mask on_face = hn::And(hn::Gt(lesser(of_b, of_c), zero), hn::Lt(hn::Add(of_b, of_c), area));
  const Number inverse = hn::Div(all(1), area);
  const Number second = clamped_share(hn::Mul(of_b, inverse));
  const Number third = clamped_between(hn::Mul(of_c, inverse), zero, hn::Sub(all(1), second));
  const Foot foot = select(on_face, foot_on_face(a, e, second, third), foot_on_edges(a, b, e));

  const Vector& d = foot.at;
  const Vector spread = plus(foot.spread, magnitudes_of(d));
  const Number squared = dot(d, d);
  const Number wrong = triangle_violation(foot, dot(e.ab, d), dot(e.ac, d), on_face);
  const Number longest = greater(greater(e.ab_squared, e.ac_squared), e.bc_squared);
  const Number rounding = hn::Mul(all(8), hn::Mul(longest, residual_floor(spread, squared)));
  const Number residual = hn::Mul(longest, hn::Add(hn::Mul(all(8), hn::Mul(wrong, wrong)), rounding));
  const Number size =
      greater(hn::Mul(all(4), dot(p, p)), greater(longest, squared));  // at most 12 · (largest coordinate)²
  const Mask near_enough = hn::Le(residual, hn::Mul(hn::Mul(all(0x1p-82 / 12), size), area));
  const Mask loses_little = hn::Le(residual, hn::Mul(all(0x1p-54), hn::Mul(squared, area)));
  const Mask plain = hn::And(hn::Gt(area, hn::Mul(all(0x1p-60), hn::Mul(longest, longest))), is_moderate(longest));
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
using Corners = std::array<Vector, 8>;

struct BoxSides {
  std::array<Number, 3> squared;  ///< of the edges from corner 0, which stand for those across
  std::array<Number, 3> inverse_squared;
  std::array<Mask, 3> far;  ///< the nearest point is beyond the middle of the edge from corner 0
};

HWY_INLINE BoxSides sides_of(const Vector& p, const Vector& origin, const std::array<Vector, 3>& neighbour) {
  BoxSides sides;
  const Vector from = minus(p, origin);
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector edge = minus(neighbour[k], origin);
    sides.squared[k] = dot(edge, edge);
    sides.inverse_squared[k] = hn::Div(all(1), sides.squared[k]);
    sides.far[k] = hn::Gt(dot(from, edge), hn::Mul(all(0.5), sides.squared[k]));
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
struct BoxRest {
  Number lowest;  ///< the least height along d over the first corner, less what it may be off by
  Number bend;    ///< how far corners are from the parallelepiped of the first four, but for rounding
};

HWY_INLINE Number certain_height(const Vector& from_first, const Vector& d, const Vector& size_of_d) {
  return hn::Sub(dot(from_first, d), hn::Mul(all(0x1p-51), dot(magnitudes_of(from_first), size_of_d)));
}

/// The nearest corner, and the three edges that leave it.
struct BoxCorner {
  Vector at;
  std::array<Vector, 3> edge;
};

HWY_INLINE BoxRest rest_of_box(const Corners& c, const std::array<Vector, 3>& edge, const Vector& d) {
  BoxRest rest{hn::Zero(Tag()), hn::Zero(Tag())};
  const Vector size_of_d = magnitudes_of(d);
  for (const Vector& e : edge) rest.lowest = lesser(rest.lowest, certain_height(e, d, size_of_d));
  for (const std::size_t i : {std::size_t{3}, std::size_t{5}, std::size_t{6}, std::size_t{7}}) {
    const Vector from_first = minus(c[i], c[0]);
    rest.lowest = lesser(rest.lowest, certain_height(from_first, d, size_of_d));
    Vector bent = from_first;
    for (std::size_t k = 0; k < 3; ++k)
      if ((i >> k & 1) != 0) bent = minus(bent, edge[k]);
    const Vector size = magnitudes_of(bent);
    rest.bend = greater(rest.bend, sum_of(size));
  }
  return rest;
}

/// `rest_along(d)` gives the rest.
template <class RestAlong>
HWY_INLINE NearPoints near_of_point_corner(const Vector& p, const BoxCorner& corner, const BoxSides& sides,
                                           const RestAlong& rest_along) {
  const Number zero = hn::Zero(Tag());
  const std::array<Number, 3>& inverse_squared = sides.inverse_squared;
  const std::array<Vector, 3>& edge = corner.edge;
  const Vector from = minus(corner.at, p);
  std::array<Number, 3> share;
  std::array<Vector, 3> step;
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    share[k] = clamped_between(hn::Neg(hn::Mul(dot(from, edge[k]), inverse_squared[k])), zero, all(0.5));
    step[k] = times(share[k], edge[k]);
  }
  const Vector steps = plus(plus(step[0], step[1]), step[2]), d = plus(from, steps);
  const Number squared = dot(d, d);
  const Vector step_sizes = plus(plus(magnitudes_of(step[0]), magnitudes_of(step[1])), magnitudes_of(step[2]));
  const Vector spread = plus(plus(magnitudes_of(from), times(all(4), step_sizes)), magnitudes_of(d));

  const BoxRest rest = rest_along(d);
  Number drift = zero, residual = zero, size = greater(hn::Mul(all(4), dot(p, p)), squared), inverses = zero;
  Mask free = hn::Eq(zero, zero);
#pragma GCC unroll 3
  for (std::size_t k = 0; k < 3; ++k) {
    const Number slope = dot(edge[k], d);
    const Mask inner = hn::Gt(share[k], zero);
    const Number wrong = hn::IfThenElse(inner, slope, lesser(slope, zero));
    residual = hn::Add(residual, hn::Mul(hn::Mul(wrong, wrong), inverse_squared[k]));
    drift = hn::Add(drift, hn::Mul(share[k], hn::Abs(slope)));
    size = greater(size, sides.squared[k]);
    inverses = hn::Add(inverses, inverse_squared[k]);
    free = hn::And(free, inner);
  }
  const Number x = dot(edge[0], edge[1]), y = dot(edge[1], edge[2]), z = dot(edge[2], edge[0]);
  const Number skew = hn::Add(hn::Add(hn::Mul(hn::Mul(x, x), hn::Mul(inverse_squared[0], inverse_squared[1])),
                                      hn::Mul(hn::Mul(y, y), hn::Mul(inverse_squared[1], inverse_squared[2]))),
                              hn::Mul(hn::Mul(z, z), hn::Mul(inverse_squared[2], inverse_squared[0])));
  // Made of differences of corners and edges, the bend is off by 4 ε of the edges' magnitudes.
  const Number edge_sizes = sum_of(plus(plus(magnitudes_of(edge[0]), magnitudes_of(edge[1])), magnitudes_of(edge[2])));
  const Number bend = hn::Add(rest.bend, hn::Mul(all(0x1.1p-51), edge_sizes)), bend_squared = hn::Mul(bend, bend);
  const Number bent =
      hn::Mul(hn::Mul(all(32), bend_squared), hn::Add(all(1), hn::Mul(all(4), hn::Mul(squared, inverses))));
  const Number floor = residual_floor(spread, squared);
  const Number all_residual = hn::Add(hn::Mul(all(16), residual), hn::Add(floor, bent));
  const Mask near_enough = hn::Le(all_residual, hn::Mul(all(0x1p-81 / 12), size));
  const Mask like_a_box = hn::Le(hn::Add(skew, hn::Mul(bend_squared, inverses)), all(0x1p-12));
  // Within the box the point is its own nearest one, but for rounding.
  const Mask within = hn::Le(hn::Add(squared, bend_squared), hn::Mul(all(0x1p-90), size));
  const Mask beside = hn::And(hn::Not(free), hn::And(near_enough, like_a_box));
  // What d is off by across itself is of second order then.
  const Mask long_enough = hn::Le(floor, hn::Mul(all(0x1p-50), squared));
  const Number drift_error = hn::Mul(all(0x1p-51), dot(step_sizes, magnitudes_of(d)));
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
HWY_INLINE NearPoints near_of_point_corners(const Vector& p, const Corners& c, const BoxSides& sides) {
  const BoxCorner corner{c[0], {minus(c[1], c[0]), minus(c[2], c[0]), minus(c[4], c[0])}};
  return near_of_point_corner(p, corner, sides, [&](const Vector& d) { return rest_of_box(c, corner.edge, d); });
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
