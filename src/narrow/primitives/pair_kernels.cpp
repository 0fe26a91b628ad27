// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/primitives/pair_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstring>

#include "narrow/primitives/column_lanes.hpp"
#include "narrow/primitives/nearness.hpp"
#include "narrow/primitives/pair_kernels.hpp"

// The formulas of closed_forms.cpp without branches, and the proofs of nearness.hpp.
HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE Number sum_of_magnitudes(const Vector& v) { return sum_of(magnitudes_of(v)); }

struct Judged {
  Mask meets, apart;
};

/// `judge` of nearness.hpp.
HWY_INLINE Judged judged(const Number& gap, const Number& squared, const Number& reach, const Number& magnitude,
                         const Number& slack) {
  const Number error =
      hn::Add(hn::Mul(all(nearness_bound), hn::Add(magnitude, reach)), hn::Add(slack, all(nearness_floor)));
  const Number inner = hn::Sub(reach, error), outer = hn::Add(reach, error);
  const Mask meets =
      hn::And(hn::Gt(inner, hn::Zero(tag)), hn::Lt(squared, hn::Mul(all(less_square), hn::Mul(inner, inner))));
  const Number needed = hn::Mul(hn::Mul(all(more_square), hn::Mul(outer, outer)), squared);
  return {meets, hn::And(hn::Gt(gap, hn::Zero(tag)), hn::Gt(hn::Mul(gap, gap), needed))};
}

/// Bit k of eight becomes byte k, 0 or 1.
HWY_INLINE std::uint64_t bytes_of_bits(std::uint64_t bits) {
  const std::uint64_t own_bit = (bits * 0x0101010101010101U) & 0x8040201008040201U;
  return ((own_bit + 0x7f7f7f7f7f7f7f7fU) >> 7) & 0x0101010101010101U;
}

HWY_INLINE void write(const Judged& judged, std::uint8_t* states) {
  std::uint8_t meets[8] = {}, known[8] = {};
  hn::StoreMaskBits(tag, judged.meets, meets);
  hn::StoreMaskBits(tag, hn::Or(judged.meets, judged.apart), known);
  const std::uint64_t eight = bytes_of_bits(meets[0]) | bytes_of_bits(~known[0] & 0xffU) << 1;
  std::memcpy(states, &eight, hn::Lanes(tag));  // the first lanes' bytes: the processors with vectors are little-endian
}

template <class Kernel>
HWY_INLINE std::size_t for_all(const PairColumns& pairs, std::uint8_t* states, const Kernel& kernel) {
  std::size_t i = 0;
  for (; i + hn::Lanes(tag) <= pairs.count; i += hn::Lanes(tag)) write(kernel(pairs, i), states + i);
  return i;
}

struct SphereSphereNearness {
  HWY_INLINE Judged operator()(const PairColumns& p, std::size_t i) const {
    const Vector d = minus(load_vector(p.a, 0, i), load_vector(p.b, 0, i));
    const Number squared = dot(d, d), reach = hn::Add(load(p.a, 3, i), load(p.b, 3, i));
    return judged(squared, squared, reach, hn::Zero(tag), hn::Zero(tag));
  }
};

struct SphereBoxNearness {
  HWY_INLINE Judged operator()(const PairColumns& p, std::size_t i) const {
    const Vector w = minus(load_vector(p.a, 0, i), load_vector(p.b, 0, i));
    Vector d = w;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Vector half = load_vector(p.b, 3 + 3 * axis, i);
      const Number share = hn::Mul(dot(w, half), load(p.b, 12 + axis, i));
      d = minus(d, times(clamped_between(share, all(-1), all(1)), half));
    }
    Number gap = dot(w, d);
    for (std::size_t axis = 0; axis < 3; ++axis) gap = hn::Sub(gap, hn::Abs(dot(load_vector(p.b, 3 + 3 * axis, i), d)));
    return judged(gap, dot(d, d), load(p.a, 3, i), hn::Add(sum_of_magnitudes(w), load(p.b, 15, i)), load(p.b, 16, i));
  }
};

/// The nearest to the origin of the points from + [0, 1] · edge.
HWY_INLINE Vector nearest_of_segment(const Vector& from, const Vector& edge) {
  return plus(from, times(clamped_share(hn::Neg(hn::Div(dot(from, edge), dot(edge, edge)))), edge));
}

HWY_INLINE Vector nearer(const Vector& u, const Vector& v) { return select(hn::Lt(dot(u, u), dot(v, v)), u, v); }

struct SphereTriangleNearness {
  HWY_INLINE Judged operator()(const PairColumns& p, std::size_t i) const {
    const Vector centre = load_vector(p.a, 0, i);
    const Vector a = minus(load_vector(p.b, 0, i), centre), b = minus(load_vector(p.b, 3, i), centre),
                 c = minus(load_vector(p.b, 6, i), centre);
    const Vector ab = minus(b, a), ac = minus(c, a), normal = cross(ab, ac);
    const Number of_a = dot(cross(b, c), normal), of_b = dot(cross(c, a), normal), of_c = dot(cross(a, b), normal);
    const Number whole = dot(normal, normal);
    const Number share_b = clamped_share(hn::Div(of_b, whole));
    const Number share_c = clamped_between(hn::Div(of_c, whole), hn::Zero(tag), hn::Sub(all(1), share_b));
    const Vector on_face = plus(plus(a, times(share_b, ab)), times(share_c, ac));
    const Vector on_edge =
        nearer(nearer(nearest_of_segment(a, ab), nearest_of_segment(a, ac)), nearest_of_segment(b, minus(c, b)));
    const Mask over_face = hn::Gt(lesser(lesser(of_a, of_b), of_c), hn::Zero(tag));
    const Vector d = select(over_face, on_face, on_edge);
    const Number gap = lesser(lesser(dot(a, d), dot(b, d)), dot(c, d));
    const Number magnitude = hn::Add(hn::Add(sum_of_magnitudes(a), sum_of_magnitudes(b)), sum_of_magnitudes(c));
    return judged(gap, dot(d, d), load(p.a, 3, i), magnitude, hn::Zero(tag));
  }
};

struct CapsuleCapsuleNearness {
  HWY_INLINE Judged operator()(const PairColumns& pairs, std::size_t i) const {
    const Vector p = load_vector(pairs.a, 0, i), r = load_vector(pairs.b, 0, i);
    const Vector u = minus(load_vector(pairs.a, 3, i), p), v = minus(load_vector(pairs.b, 3, i), r);
    const Vector difference = minus(p, r);
    const Number uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
    const Number along_u = dot(u, difference), along_v = dot(v, difference);
    const Number determinant = hn::Sub(hn::Mul(uu, vv), hn::Mul(uv, uv));
    const Number first_s = clamped_share(hn::Div(hn::Sub(hn::Mul(uv, along_v), hn::Mul(along_u, vv)), determinant));
    const Number t = clamped_share(hn::Div(hn::Add(hn::Mul(uv, first_s), along_v), vv));
    // Where t was within its segment this is the first s again, but for rounding.
    const Number s = clamped_share(hn::Div(hn::Sub(hn::Mul(uv, t), along_u), uu));
    const Vector d = minus(plus(difference, times(s, u)), times(t, v));
    const Number zero = hn::Zero(tag);
    const Number least_a = hn::Add(dot(difference, d), lesser(zero, dot(u, d)));
    const Number greatest_b = hn::Neg(lesser(zero, hn::Neg(dot(v, d))));
    const Number magnitude =
        hn::Add(hn::Add(sum_of_magnitudes(difference), sum_of_magnitudes(u)), sum_of_magnitudes(v));
    const Number reach = hn::Add(load(pairs.a, 6, i), load(pairs.b, 6, i));
    return judged(hn::Sub(least_a, greatest_b), dot(d, d), reach, magnitude, zero);
  }
};

struct BoxBoxNearness {
  HWY_INLINE Judged operator()(const PairColumns& p, std::size_t i) const {
    Mask meets = hn::And(hn::Le(load(p.a, 0, i), load(p.b, 3, i)), hn::Le(load(p.b, 0, i), load(p.a, 3, i)));
    for (std::size_t axis = 1; axis < 3; ++axis) {
      meets = hn::And(meets, hn::Le(load(p.a, axis, i), load(p.b, axis + 3, i)));
      meets = hn::And(meets, hn::Le(load(p.b, axis, i), load(p.a, axis + 3, i)));
    }
    return {meets, hn::Not(meets)};
  }
};

}  // namespace

std::size_t sphere_sphere_states(const PairColumns& pairs, std::uint8_t* states) {
  return for_all(pairs, states, SphereSphereNearness{});
}
std::size_t sphere_triangle_states(const PairColumns& pairs, std::uint8_t* states) {
  return for_all(pairs, states, SphereTriangleNearness{});
}
std::size_t sphere_box_states(const PairColumns& pairs, std::uint8_t* states) {
  return for_all(pairs, states, SphereBoxNearness{});
}
std::size_t capsule_capsule_states(const PairColumns& pairs, std::uint8_t* states) {
  return for_all(pairs, states, CapsuleCapsuleNearness{});
}
std::size_t box_box_states(const PairColumns& pairs, std::uint8_t* states) {
  return for_all(pairs, states, BoxBoxNearness{});
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(sphere_sphere_states);
HWY_EXPORT(sphere_triangle_states);
HWY_EXPORT(sphere_box_states);
HWY_EXPORT(capsule_capsule_states);
HWY_EXPORT(box_box_states);

PairKernels pair_kernels() {
  return {&HWY_DYNAMIC_DISPATCH(sphere_sphere_states), &HWY_DYNAMIC_DISPATCH(sphere_triangle_states),
          &HWY_DYNAMIC_DISPATCH(sphere_box_states), &HWY_DYNAMIC_DISPATCH(capsule_capsule_states),
          &HWY_DYNAMIC_DISPATCH(box_box_states)};
}

}  // namespace toccata
#endif
