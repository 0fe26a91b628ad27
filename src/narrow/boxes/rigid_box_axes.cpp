// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/boxes/rigid_box_axes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "math/world_vertex.hpp"

#include "narrow/boxes/rigid_box_axes.hpp"
#include "narrow/convex/rows.hpp"

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

struct ThreeRows {
  Row row[3];
};

#if HWY_TARGET <= HWY_AVX2
HWY_INLINE ThreeRows transposed(const Row (&rows)[3]) {
  const hn::Vec<RowTag> first = rows[0].part[0], second = rows[1].part[0], third = rows[2].part[0];
  const hn::Vec<RowTag> even = hn::InterleaveLower(row_tag, first, second),
                        odd = hn::InterleaveUpper(row_tag, first, second);
  return {{{{hn::ConcatLowerLower(row_tag, third, even)}},
           {{hn::ConcatLowerLower(row_tag, hn::InterleaveUpper(row_tag, third, third), odd)}},
           {{hn::ConcatUpperUpper(row_tag, third, even)}}}};
}
#endif

/// What the axes depend on.
struct TwoBoxes {
  const Mat3& axes_a;
  const Mat3& axes_b;
  const Vec3& half_a;
  const Vec3& half_b;
  const Vec3& centre_a;
  const Vec3& centre_b;
  // The same, and from A to B.
  Row row_a, row_b, way;
};

struct AxesInRows {
  Row way_a, way_b, overlap_a, overlap_b;
  Row cosines[3], turned[3], edge_overlap[3];
};

/// The error of each overlap; `sizes` are all extents and the way.
struct AxesError {
  double sizes, error;
};

/// A sum of rows.
HWY_INLINE Row combined(const Vec3& weights, const Row& first, const Row& second, const Row& third) {
  return (weights.x * first + weights.y * second) + weights.z * third;
}

HWY_INLINE Vec3 column(const Mat3& m, int j) { return {m[0][j], m[1][j], m[2][j]}; }

// Nothing here is a loop, which compilers might keep.
HWY_INLINE void look_along_faces(const TwoBoxes& boxes, AxesInRows& axes) {
  const Mat3 &r = boxes.axes_a, &s = boxes.axes_b;
  const Row r0 = load(&r[0].x), r1 = load(&r[1].x), r2 = load(&r[2].x);
  const Row s0 = load(&s[0].x), s1 = load(&s[1].x), s2 = load(&s[2].x);
  const Vec3 way = boxes.centre_b - boxes.centre_a;
  axes.way_a = combined(way, r0, r1, r2);
  axes.way_b = combined(way, s0, s1, s2);
  axes.cosines[0] = combined(column(r, 0), s0, s1, s2);
  axes.cosines[1] = combined(column(r, 1), s0, s1, s2);
  axes.cosines[2] = combined(column(r, 2), s0, s1, s2);
#if HWY_TARGET <= HWY_AVX2
  const ThreeRows turned = transposed(axes.cosines);
#else
  const ThreeRows turned = {{combined(column(s, 0), r0, r1, r2), combined(column(s, 1), r0, r1, r2),
                             combined(column(s, 2), r0, r1, r2)}};  // the same sums of the same products
#endif
  axes.turned[0] = turned.row[0];
  axes.turned[1] = turned.row[1];
  axes.turned[2] = turned.row[2];
  const Row reach_b =
      combined(boxes.half_a, magnitude(axes.cosines[0]), magnitude(axes.cosines[1]), magnitude(axes.cosines[2]));
  const Row reach_a =
      combined(boxes.half_b, magnitude(turned.row[0]), magnitude(turned.row[1]), magnitude(turned.row[2]));
  axes.overlap_a = (boxes.row_a + reach_a) - magnitude(axes.way_a);
  axes.overlap_b = (boxes.row_b + reach_b) - magnitude(axes.way_b);
}

/// What the edge pairs of all three rows have in common.
struct EdgeRows {
  FourDoubles way;           ///< along the edges of A
  Row size[3];               ///< of the cosines
  Row next_half, last_half;  ///< the half extents of B that are not those of the edge
};

/// Along the edge of A that is followed by two of the half extents `h_k` and `h_l`.
template <std::size_t i, std::size_t k, std::size_t l>
HWY_INLINE Row overlap_of_edges(const AxesInRows& axes, const EdgeRows& sides, double h_k, double h_l) {
  const Row way = sides.way[l] * axes.cosines[k] - sides.way[k] * axes.cosines[l];
  const Row next_size = next(sides.size[i]), last_size = next(next_size);
  const Row reach_a = h_k * sides.size[l] + h_l * sides.size[k];
  const Row reach_b = sides.next_half * last_size + sides.last_half * next_size;
  return (reach_a + reach_b) - magnitude(way);
}

HWY_INLINE void look_along_edges(const TwoBoxes& boxes, AxesInRows& axes) {
  const Vec3& h = boxes.half_a;
  EdgeRows sides;
  store(axes.way_a, sides.way.data());
  sides.size[0] = magnitude(axes.cosines[0]);
  sides.size[1] = magnitude(axes.cosines[1]);
  sides.size[2] = magnitude(axes.cosines[2]);
  sides.next_half = next(boxes.row_b);
  sides.last_half = next(sides.next_half);
  axes.edge_overlap[0] = overlap_of_edges<0, 1, 2>(axes, sides, h.y, h.z);
  axes.edge_overlap[1] = overlap_of_edges<1, 2, 0>(axes, sides, h.z, h.x);
  axes.edge_overlap[2] = overlap_of_edges<2, 0, 1>(axes, sides, h.x, h.y);
}

/// The least of the first three, in all of them.
HWY_INLINE Row least_of_three(const Row& row) {
  const Row after = next(row);
  return lesser(lesser(row, after), next(after));
}

HWY_INLINE unsigned places_of(const Row& least, const Row& row, unsigned first) {
  return (bits_of(row == least) & 7U) << first;
}

HWY_INLINE Index first_of(unsigned bits) { return static_cast<Index>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits)); }

HWY_INLINE Index place_of_least_face(const AxesInRows& axes) {
  const Row least = least_of_three(lesser(axes.overlap_a, axes.overlap_b));
  return first_of(places_of(least, axes.overlap_a, 0) | places_of(least, axes.overlap_b, 3) | 1U << 5);
}

/// Signed squares of depths are compared, without roots.
HWY_INLINE Row squared_depth(const Row& overlap, const Row& cosine, const Row& other_cosine) {
  const Row sine = cosine * cosine + other_cosine * other_cosine;
  const RowMask makes_axis = row_of(least_sine_of_edges * least_sine_of_edges) < sine;
  return select(makes_axis, overlap * magnitude(overlap) / sine, row_of(0x1p1000));
}

HWY_INLINE Index place_of_least_edges(const AxesInRows& axes) {
  const Row first = squared_depth(axes.edge_overlap[0], axes.cosines[1], axes.cosines[2]);
  const Row second = squared_depth(axes.edge_overlap[1], axes.cosines[2], axes.cosines[0]);
  const Row third = squared_depth(axes.edge_overlap[2], axes.cosines[0], axes.cosines[1]);
  const Row least = least_of_three(lesser(lesser(first, second), third));
  return first_of(places_of(least, first, 0) | places_of(least, second, 3) | places_of(least, third, 6) | 1U << 8);
}

HWY_INLINE void store_all(const AxesInRows& axes, double error, RigidBoxAxes& stored) {
  stored.error = error;
  store(axes.way_a, stored.way_a.data());
  store(axes.way_b, stored.way_b.data());
  store(axes.overlap_a, stored.overlap_a.data());
  store(axes.overlap_b, stored.overlap_b.data());
  store(axes.cosines[0], stored.cosines[0].data());
  store(axes.cosines[1], stored.cosines[1].data());
  store(axes.cosines[2], stored.cosines[2].data());
  store(axes.turned[0], stored.turned_cosines[0].data());
  store(axes.turned[1], stored.turned_cosines[1].data());
  store(axes.turned[2], stored.turned_cosines[2].data());
  store(axes.edge_overlap[0], stored.edge_overlap[0].data());
  store(axes.edge_overlap[1], stored.edge_overlap[1].data());
  store(axes.edge_overlap[2], stored.edge_overlap[2].data());
}

/// Fills in the axes, but for those of edges where faces part the boxes by far.
HWY_INLINE Nearness look_along_axes(const TwoBoxes& boxes, const AxesError& error, AxesInRows& axes) {
  const auto is_any = [](const RowMask& mask) { return (bits_of(mask) & 7U) != 0; };
  look_along_faces(boxes, axes);
  const Row faces = lesser(axes.overlap_a, axes.overlap_b);
  // Only where the faces part the boxes by far, so that the branch is easy to guess: less than that, and to look along
  // the edges as well costs less than a wrong guess.
  if (is_any(faces < row_of(-(error.error + 0x1p-5 * error.sizes)))) return Nearness::apart;
  look_along_edges(boxes, axes);
  const Row edges = lesser(lesser(axes.edge_overlap[0], axes.edge_overlap[1]), axes.edge_overlap[2]);
  const Row all = lesser(faces, edges);
  if (is_any(all < row_of(-error.error))) return Nearness::apart;
  return error.error < 0x1p1000 && !is_any(all <= row_of(error.error)) ? Nearness::meet : Nearness::unknown;
}

/// The place of an axis that separates boxes that are apart. Where no face parts them all axes have been filled in.
HWY_INLINE Index place_of_separating_axis(const AxesInRows& axes, double error) {
  const auto apart = [&](const Row& overlap, unsigned first) {
    return (bits_of(overlap < row_of(-error)) & 7U) << first;
  };
  const unsigned faces = apart(axes.overlap_a, 0) | apart(axes.overlap_b, 3);
  if (faces != 0) return first_of(faces);
  return first_of(apart(axes.edge_overlap[0], 6) | apart(axes.edge_overlap[1], 9) | apart(axes.edge_overlap[2], 12) |
                  1U << 14);
}

HWY_INLINE double sizes_of(const TwoBoxes& boxes) {
  return sum_of_three((boxes.row_a + boxes.row_b) + magnitude(boxes.way));
}

HWY_INLINE AxesError error_of(const BoxView& a, const BoxView& b, const TwoBoxes& boxes) {
  const double sizes = sizes_of(boxes);
  return {sizes, (0x1p-47 + 16 * (a.box->skew + b.box->skew)) * sizes + (a.box->slack + b.box->slack)};
}

/// The entries of |RᵀR − I| in and beside its diagonal, three and three added.
HWY_INLINE Row skews_of(const Mat3& r) {
  const Row r0 = load(&r[0].x), r1 = load(&r[1].x), r2 = load(&r[2].x);
  const Row squares = (r0 * r0 + r1 * r1) + r2 * r2;
  const Row products = (r0 * next(r0) + r1 * next(r1)) + r2 * next(r2);
  return magnitude(squares - row_of(1)) + magnitude(products);
}

/// As for boxes that were posed before, but rougher. All entries of |RᵀR − I| together are more than the greatest, and
/// what they are off by is less than a sixteenth of them and 2^-50, 16 of which make 2^-45 for the two. No corner or
/// centre is off by more than 32 · 2^-53 of the local and the pose's coordinates that it was made of (rigid_box.cpp),
/// of which the share of the sizes makes 2^-45 to 0x1.2p-45.
HWY_INLINE AxesError error_of(const Pose& pose_a, const Pose& pose_b, const TwoBoxes& boxes, const Row& places) {
  const double skew = sum_of_three(skews_of(pose_a.linear) + skews_of(pose_b.linear)), sizes = sizes_of(boxes);
  const Row offsets = magnitude(load_three(pose_a.offset)) + magnitude(load_three(pose_b.offset));
  const double slack = 0x1p-48 * sum_of_three(places + offsets) + 0x1p-999;
  const bool is_rigid = skew < 0x1p-21 && slack < 0x1p900;
  return {sizes, is_rigid ? (0x1.2p-45 + 17 * skew) * sizes + slack : HUGE_VAL};
}

}  // namespace

Nearness rigid_boxes_along_axes(const BoxView& a, const BoxView& b, RigidBoxAxes& stored, Storing storing) {
  const RigidBox &p = *a.box, &q = *b.box;
  const TwoBoxes boxes{*a.axes,
                       *b.axes,
                       p.half_extents,
                       q.half_extents,
                       p.centre,
                       q.centre,
                       load(&p.half_extents.x),
                       load(&q.half_extents.x),
                       load(&q.centre.x) - load(&p.centre.x)};
  const AxesError error = error_of(a, b, boxes);
  AxesInRows axes;
  const Nearness nearness = look_along_axes(boxes, error, axes);
  if (nearness == Nearness::apart) {
    if (storing == Storing::always) stored.separating_axis = place_of_separating_axis(axes, error.error);
    return nearness;
  }
  if (storing == Storing::always || nearness == Nearness::unknown) store_all(axes, error.error, stored);
  if (storing == Storing::always) {
    stored.least_face = place_of_least_face(axes);
    stored.least_edges = place_of_least_edges(axes);
  }
  return nearness;
}

Nearness boxes_along_axes(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b, RigidBoxAxes& stored) {
  const Row places = magnitude(load_three(a.centre())) + magnitude(load_three(b.centre()));
  const Vec3 *centre_a = &pose_a.offset, *centre_b = &pose_b.offset;
  Vec3 moved_a, moved_b;
  if ((bits_of(places == row_of(0)) & 7U) != 7) {
    moved_a = world_vertex(pose_a, a.centre());
    moved_b = world_vertex(pose_b, b.centre());
    centre_a = &moved_a;
    centre_b = &moved_b;
  }
  const TwoBoxes boxes{pose_a.linear,
                       pose_b.linear,
                       a.half_extents(),
                       b.half_extents(),
                       *centre_a,
                       *centre_b,
                       load_three(a.half_extents()),
                       load_three(b.half_extents()),
                       load_three(*centre_b) - load_three(*centre_a)};
  const AxesError error = error_of(pose_a, pose_b, boxes, places);
  AxesInRows axes;
  const Nearness nearness = look_along_axes(boxes, error, axes);
  if (nearness == Nearness::unknown) store_all(axes, error.error, stored);
  return nearness;
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(rigid_boxes_along_axes);
HWY_EXPORT(boxes_along_axes);

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

/// What is left unknown of boxes with parallel edges; that is what most boxes are that nobody has turned.
Nearness whatever_edges_tell(const RigidBoxAxes& axes, const Vec3& half_extents_b) {
  const bool meet = faces_overlap(axes) && nearly_parallel_edges_do_not_matter(axes, half_extents_b);
  return meet ? Nearness::meet : Nearness::unknown;
}

Nearness nearness_with(const BoxView& a, const BoxView& b, RigidBoxAxes& axes, Storing storing) {
  const Nearness nearness = HWY_DYNAMIC_DISPATCH(rigid_boxes_along_axes)(a, b, axes, storing);
  return nearness == Nearness::unknown ? whatever_edges_tell(axes, b.box->half_extents) : nearness;
}

}  // namespace

Nearness nearness_of_rigid_boxes(const BoxView& a, const BoxView& b) {
  RigidBoxAxes axes;
  return nearness_with(a, b, axes, Storing::where_unsure);
}

Nearness nearness_of_boxes(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  RigidBoxAxes axes;
  const Nearness nearness = HWY_DYNAMIC_DISPATCH(boxes_along_axes)(a, pose_a, b, pose_b, axes);
  return nearness == Nearness::unknown ? whatever_edges_tell(axes, b.half_extents()) : nearness;
}

Nearness nearness_of_rigid_boxes(const BoxView& a, const BoxView& b, RigidBoxAxes& axes) {
  return nearness_with(a, b, axes, Storing::always);
}

}  // namespace toccata
#endif
