// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/rigid_box_axes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "narrow/rigid_box_axes.hpp"

// Let r_i and s_j be the columns of the two poses, h and g the half extents, d the way between the centres, and δ the
// greater |RᵀR − I| of the two. A row of vectors holds what belongs to the edges j of B, or to the edges i of A.
//
// Rounding. With u = 2^-53, a cosine r_i · s_j is off by 3u, the way r_i · d by 4u |d|; what is summed up from them by
// less than 32u (h + g + |d|), all coordinates added.
//
// Skewness. R = Q (I + S), Q orthogonal, S symmetric, |S| ≤ 1.5δ. The face normal r_k × r_l lies within 3δ of r_i,
// which is 1.5δ longer or shorter, and in r_i · r_k for k ≠ i another δ is neglected: 5.5δ of the sizes. In edge pairs
// r_k × r_i = ±r_l up to 4.5δ, and d = Σ (r_k · d) r_k up to 3δ |d|: less than 11δ of the sizes. So 16 (δ_A + δ_B)
// holds for all.
//
// An axis whose overlap is less than −error separates, whichever direction it is. All fifteen with more than the error:
// every facet of the Minkowski difference lies beyond the origin, and by more than corners are off, so that the hulls
// of the rounded corners meet as well; their interiors do. Nearly parallel edges r_i and s_j make an axis of next to no
// length. Seen along r_i the difference is a polygon, of which the image of s_j, of length 2 g_j sin, is a side;
// without it the polygon's sides are those of the faces k and l of A and of the edge pairs of r_i with s_m and s_n.
// Where these four overlap by more than g_j sin, the fifth does.
HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, 4>;
using Number = hn::Vec<Tag>;
constexpr Tag tag;
constexpr std::size_t lanes = hn::MaxLanes(tag), parts = 4 / lanes;

/// Three numbers and one that does not matter.
struct Row {
  Number part[parts];
};

template <class Function>
HWY_INLINE Row each(const Function& function) {
  Row result;
  for (std::size_t k = 0; k < parts; ++k) result.part[k] = function(k);
  return result;
}

HWY_INLINE Row load(const double* from) {
  return each([&](std::size_t k) { return hn::LoadU(tag, from + k * lanes); });
}
HWY_INLINE void store(const Row& row, FourDoubles& to) {
  for (std::size_t k = 0; k < parts; ++k) hn::StoreU(row.part[k], tag, to.data() + k * lanes);
}
HWY_INLINE Row operator+(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Add(u.part[k], v.part[k]); });
}
HWY_INLINE Row operator-(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Sub(u.part[k], v.part[k]); });
}
HWY_INLINE Row operator*(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Mul(u.part[k], v.part[k]); });
}
HWY_INLINE Row operator*(double s, const Row& v) {
  return each([&](std::size_t k) { return hn::Mul(hn::Set(tag, s), v.part[k]); });
}
HWY_INLINE Row magnitude(const Row& v) {
  return each([&](std::size_t k) { return hn::Abs(v.part[k]); });
}
HWY_INLINE Row least(const Row& u, const Row& v) {
  return each([&](std::size_t k) { return hn::Min(u.part[k], v.part[k]); });
}

template <class Comparison>
HWY_INLINE bool any_of_three(const Row& row, const Comparison& comparison) {
  unsigned bits = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    std::uint8_t few[8] = {};
    hn::StoreMaskBits(tag, comparison(row.part[k]), few);
    bits |= static_cast<unsigned>(few[0]) << (k * lanes);
  }
  return (bits & 7U) != 0;
}
HWY_INLINE bool is_any_less(const Row& row, double limit) {
  return any_of_three(row, [&](const Number& x) { return hn::Lt(x, hn::Set(tag, limit)); });
}
HWY_INLINE bool is_any_at_most(const Row& row, double limit) {
  return any_of_three(row, [&](const Number& x) { return hn::Le(x, hn::Set(tag, limit)); });
}

/// The number j + 1, of three, in place of the j-th.
HWY_INLINE Row next(const Row& row) {
#if HWY_TARGET <= HWY_AVX2
  alignas(32) static constexpr std::int64_t order[4] = {1, 2, 0, 3};
  return {{hn::TableLookupLanes(row.part[0], hn::SetTableIndices(tag, order))}};
#else
  alignas(64) double thrice[8];
  for (std::size_t k = 0; k < parts; ++k) hn::StoreU(row.part[k], tag, thrice + k * lanes);
  thrice[3] = thrice[0];
  thrice[4] = thrice[1];
  return load(thrice + 1);
#endif
}

struct ThreeRows {
  Row row[3];
};

#if HWY_TARGET <= HWY_AVX2
HWY_INLINE ThreeRows transposed(const Row (&rows)[3]) {
  const Number first = rows[0].part[0], second = rows[1].part[0], third = rows[2].part[0];
  const Number even = hn::InterleaveLower(tag, first, second), odd = hn::InterleaveUpper(tag, first, second);
  return {{{{hn::ConcatLowerLower(tag, third, even)}},
           {{hn::ConcatLowerLower(tag, hn::InterleaveUpper(tag, third, third), odd)}},
           {{hn::ConcatUpperUpper(tag, third, even)}}}};
}
#endif

struct Axes {
  Row way_a, way_b, overlap_a, overlap_b;
  Row cosines[3], edge_way[3], edge_overlap[3];
  double sizes, error;
};

HWY_INLINE double sum(const Vec3& v) { return (v.x + v.y) + v.z; }

HWY_INLINE void look_along_faces(const BoxView& a, const BoxView& b, Axes& axes) {
  const Vec3 d = b.box->centre - a.box->centre, h = a.box->half_extents, g = b.box->half_extents;
  const Mat3 &r = *a.axes, &s = *b.axes;
  const Row r0 = load(&r[0].x), r1 = load(&r[1].x), r2 = load(&r[2].x);
  const Row s0 = load(&s[0].x), s1 = load(&s[1].x), s2 = load(&s[2].x);
  axes.way_a = (d.x * r0 + d.y * r1) + d.z * r2;
  axes.way_b = (d.x * s0 + d.y * s1) + d.z * s2;
  Row reach_a = load(&a.box->half_extents.x), reach_b = load(&b.box->half_extents.x);
  for (int i = 0; i < 3; ++i) {
    axes.cosines[i] = (r[0][i] * s0 + r[1][i] * s1) + r[2][i] * s2;
    reach_b = reach_b + h[i] * magnitude(axes.cosines[i]);
  }
#if HWY_TARGET <= HWY_AVX2
  const ThreeRows turned = transposed(axes.cosines);
#else
  ThreeRows turned;  // the same sums of the same products
  for (int i = 0; i < 3; ++i) turned.row[i] = (s[0][i] * r0 + s[1][i] * r1) + s[2][i] * r2;
#endif
  for (int i = 0; i < 3; ++i) reach_a = reach_a + g[i] * magnitude(turned.row[i]);
  axes.overlap_a = reach_a - magnitude(axes.way_a);
  axes.overlap_b = reach_b - magnitude(axes.way_b);
  axes.sizes = (sum(h) + sum(g)) + ((std::fabs(d.x) + std::fabs(d.y)) + std::fabs(d.z));
  axes.error = (0x1p-47 + 16 * (a.box->skew + b.box->skew)) * axes.sizes + (a.box->slack + b.box->slack);
}

HWY_INLINE void look_along_edges(const BoxView& a, const BoxView& b, Axes& axes) {
  const Vec3& h = a.box->half_extents;
  const Row g = load(&b.box->half_extents.x), next_g = next(g), last_g = next(next_g);
  FourDoubles way;
  store(axes.way_a, way);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = i == 2 ? 0 : i + 1, l = 3 - i - k;
    const Row here = magnitude(axes.cosines[i]), next_here = next(here), last_here = next(next_here);
    axes.edge_way[i] = way[l] * axes.cosines[k] - way[k] * axes.cosines[l];
    const Row reach_a =
        h[static_cast<int>(k)] * magnitude(axes.cosines[l]) + h[static_cast<int>(l)] * magnitude(axes.cosines[k]);
    const Row reach_b = next_g * last_here + last_g * next_here;
    axes.edge_overlap[i] = (reach_a + reach_b) - magnitude(axes.edge_way[i]);
  }
}

void store_all(const Axes& axes, RigidBoxAxes& stored) {
  stored.error = axes.error;
  store(axes.way_a, stored.way_a);
  store(axes.way_b, stored.way_b);
  store(axes.overlap_a, stored.overlap_a);
  store(axes.overlap_b, stored.overlap_b);
  for (std::size_t i = 0; i < 3; ++i) {
    store(axes.cosines[i], stored.cosines[i]);
    store(axes.edge_way[i], stored.edge_way[i]);
    store(axes.edge_overlap[i], stored.edge_overlap[i]);
  }
}

}  // namespace

Nearness rigid_boxes_along_axes(const BoxView& a, const BoxView& b, RigidBoxAxes& stored, Storing storing) {
  Axes axes;
  look_along_faces(a, b, axes);
  const Row faces = least(axes.overlap_a, axes.overlap_b);
  // Only where the faces part the boxes by far, so that the branch is easy to guess: less than that, and to look along
  // the edges as well costs less than a wrong guess.
  if (is_any_less(faces, -(axes.error + 0x1p-5 * axes.sizes))) return Nearness::apart;
  look_along_edges(a, b, axes);
  const Row edges = least(least(axes.edge_overlap[0], axes.edge_overlap[1]), axes.edge_overlap[2]);
  if (is_any_less(least(faces, edges), -axes.error)) return Nearness::apart;
  const bool sure = axes.error < 0x1p1000 && !is_any_at_most(least(faces, edges), axes.error);
  if (storing == Storing::always || !sure) store_all(axes, stored);
  return sure ? Nearness::meet : Nearness::unknown;
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(rigid_boxes_along_axes);

/// The edge pairs without length.
bool nearly_parallel_edges_do_not_matter(const RigidBoxAxes& axes, const Vec3& half_extents_b) {
  const auto is_sure = [&](double overlap, double more) { return overlap > axes.error + more; };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      if (is_sure(axes.edge_overlap[i][j], 0)) continue;
      const std::size_t k = (i + 1) % 3, l = 3 - i - k, m = (j + 1) % 3, n = 3 - j - m;
      const double side =
          2 * half_extents_b[static_cast<int>(j)] * (std::fabs(axes.cosines[k][j]) + std::fabs(axes.cosines[l][j]));
      // The sine is as rough as the cosines are, of which the error is enough.
      if (!is_sure(std::min({axes.overlap_a[k], axes.overlap_a[l], axes.edge_overlap[i][m], axes.edge_overlap[i][n]}),
                   side + 2 * axes.error))
        return false;
    }
  return true;
}

bool faces_overlap(const RigidBoxAxes& axes) {
  const auto overlap = [&](double along) { return along > axes.error; };
  return std::all_of(axes.overlap_a.begin(), axes.overlap_a.begin() + 3, overlap) &&
         std::all_of(axes.overlap_b.begin(), axes.overlap_b.begin() + 3, overlap);
}

Nearness nearness_with(const BoxView& a, const BoxView& b, RigidBoxAxes& axes, Storing storing) {
  const Nearness nearness = HWY_DYNAMIC_DISPATCH(rigid_boxes_along_axes)(a, b, axes, storing);
  if (nearness != Nearness::unknown || !faces_overlap(axes)) return nearness;
  return nearly_parallel_edges_do_not_matter(axes, b.box->half_extents) ? Nearness::meet : Nearness::unknown;
}

}  // namespace

Nearness nearness_of_rigid_boxes(const BoxView& a, const BoxView& b) {
  RigidBoxAxes axes;
  return nearness_with(a, b, axes, Storing::where_unsure);
}

Nearness nearness_of_rigid_boxes(const BoxView& a, const BoxView& b, RigidBoxAxes& axes) {
  return nearness_with(a, b, axes, Storing::always);
}

}  // namespace toccata
#endif
