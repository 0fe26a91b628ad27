// A point or a segment beside a box: which of their features may be the nearest, found in the box's frame.
// docs/design/primitive-depths.md. Included once for every SIMD level, like math/lanes.hpp.
#if defined(TOCCATA_NARROW_BOX_CORES_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TOCCATA_NARROW_BOX_CORES_HPP
#undef TOCCATA_NARROW_BOX_CORES_HPP
#else
#define TOCCATA_NARROW_BOX_CORES_HPP
#endif

#include "narrow/boxes/box_features.hpp"
#include "narrow/boxes/box_slack.hpp"
#include "narrow/primitives/offset_core_pair.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

using ThreeNumbers = std::array<double, 3>;

HWY_INLINE ThreeNumbers numbers_of(const OneVector& v) {
  return {first_of(x_of(v)), first_of(y_of(v)), first_of(z_of(v))};
}

/// The corners of a box in the world, each rounded by itself: stored, or made where they are needed.
class BlockCorners {
 public:
  HWY_INLINE BlockCorners(const Box& box, const Pose& pose) : box_(&box), placing_(pose) {}
  HWY_INLINE explicit BlockCorners(const PosedPolytope& box)
      : placing_(box.pose()), along_{box.along(0), box.along(1), box.along(2)} {}

  [[nodiscard]] HWY_INLINE OneVector operator()(Index i) const {
    if (box_ == nullptr) return in_one(along_[0][i], along_[1][i], along_[2][i]);
    const Vec3 lower = box_->centre() - box_->half_extents(), upper = box_->centre() + box_->half_extents();
    return placing_(
        {(i & 1U) != 0 ? upper.x : lower.x, (i & 2U) != 0 ? upper.y : lower.y, (i & 4U) != 0 ? upper.z : lower.z});
  }

 private:
  const Box* box_ = nullptr;  ///< null: they are stored
  Placing placing_;
  std::array<const double*, 3> along_{};
};

/// A box under a pose that is rigid but for rounding.
struct OneBlock {
  const Mat3& axes;  ///< as columns
  OneVector centre;  ///< in the world, rounded
  OneVector half;
  double slack;   ///< no corner is farther than this from centre ± half · axes
  double radius;  ///< by which it is grown
  BlockCorners corner;

  /// In the box's frame, from its centre.
  [[nodiscard]] HWY_INLINE OneVector local(const OneVector& from_centre) const {
    const ThreeNumbers w = numbers_of(from_centre);
    return plus(plus(scaled(w[0], in_one(axes[0])), scaled(w[1], in_one(axes[1]))), scaled(w[2], in_one(axes[2])));
  }
  [[nodiscard]] HWY_INLINE OneVector turned(const OneVector& local) const {
    return in_one(first_of(dot(in_one(axes[0]), local)), first_of(dot(in_one(axes[1]), local)),
                  first_of(dot(in_one(axes[2]), local)));
  }
};

HWY_INLINE OneBlock in_world(const Box& box, const Pose& pose) {
  return {pose.linear,
          placed_in_one(pose, box.centre()),
          in_one(box.half_extents()),
          slack_of(box, pose),
          0,
          BlockCorners(box, pose)};
}

/// How a point lies beside a box. Distances in the box's frame are off by `error`: see rigid_overlap.cpp.
struct BesideBox {
  ThreeNumbers at, half;
  ThreeNumbers beyond{};  ///< the face; negative: before it
  double squared = 0;     ///< of the distance, where it is not inside
  double error = 0;
  std::size_t across = 0;  ///< the axis along which it is the farthest beyond

  /// Which corner is the nearest, and how it lies to the face, tells a bit for each axis.
  [[nodiscard]] HWY_INLINE Index corner() const {
    return static_cast<Index>(at[0] > 0) | static_cast<Index>(at[1] > 0) << 1U | static_cast<Index>(at[2] > 0) << 2U;
  }
  [[nodiscard]] HWY_INLINE bool is_before(std::size_t axis) const { return beyond[axis] < 0; }
  /// The share of an edge's length at which the nearest point is, from the nearest corner on.
  [[nodiscard]] HWY_INLINE double share(std::size_t axis) const {
    return is_before(axis) ? -beyond[axis] / (2 * half[axis]) : 0;
  }
};

HWY_INLINE double local_frame_error(const OneBlock& block, const OneVector& from_centre) {
  return 0x1p-40 * first_of(sum_of(plus(magnitudes_of(from_centre), magnitudes_of(block.half)))) +
         (2 * block.slack + nearness_floor);
}

HWY_INLINE BesideBox beside(const OneVector& local, const OneVector& half, double error) {
  BesideBox b{numbers_of(local), numbers_of(half)};
  b.error = error;
  for (std::size_t k = 0; k < 3; ++k) {
    b.beyond[k] = std::fabs(b.at[k]) - b.half[k];
    const double outside = b.beyond[k] > 0 ? b.beyond[k] : 0;
    b.squared += outside * outside;
  }
  b.across = b.beyond[1] > b.beyond[0] ? 1 : 0;
  b.across = b.beyond[2] > b.beyond[b.across] ? 2 : b.across;
  return b;
}

/// The way from the nearest point of the box, in the world.
HWY_INLINE OneVector way_from(const OneBlock& block, const BesideBox& b) {
  ThreeNumbers outside;
  for (std::size_t k = 0; k < 3; ++k) outside[k] = b.is_before(k) ? 0 : std::copysign(b.beyond[k], b.at[k]);
  return block.turned(in_one(outside[0], outside[1], outside[2]));
}

HWY_INLINE OneVector select(bool yes, const OneVector& a, const OneVector& b) {
  return select(hn::Gt(all<OneNumber>(yes ? 1 : 0), hn::Zero(OneTag())), a, b);
}

/// Two edges of the box that leave its nearest corner, those of B turned round, and the way along the third. A face is
/// bent by rounding: where its fourth corner is before the plane of the other three, the nearest point lies in a
/// triangle with it.
struct BoxSide {
  OneVector corner;
  std::array<CoreEdge, 2> edge;
  OneVector beyond;
  bool is_certain = false;  ///< the triangle
};

HWY_INLINE BoxSide side_of(const OneBlock& block, const BesideBox& b, const OneVector& point) {
  const std::size_t i = b.across == 2 ? 0 : b.across + 1, j = b.across == 0 ? 2 : b.across - 1;
  const Index first = b.corner(), at_i = first ^ Index { 1 } << i, at_j = first ^ Index { 1 } << j;
  const OneVector c = block.corner(first), ci = block.corner(at_i), cj = block.corner(at_j),
                  cij = block.corner(at_i ^ Index{1} << j), opposite = block.corner(first ^ Index{1} << b.across);
  const double share_i = b.share(i), share_j = b.share(j);
  const double inverse_i = 0.5 / b.half[i], inverse_j = 0.5 / b.half[j];
  const LongVector one = exact_difference(cij, ci), other = exact_difference(cj, c);
  const OneVector bend = plus(minus(one.high, other.high), minus(one.low, other.low));
  const OneVector way = plus(minus(point, c), plus(scaled(share_i, minus(c, ci)), scaled(share_j, minus(c, cj))));
  const double height = first_of(dot(bend, way));
  const double sure = 0x1p-28 * (first_of(sum_of(magnitudes_of(bend))) * first_of(sum_of(magnitudes_of(way))));
  const bool is_face = (share_i > 0) & (share_j > 0), is_before = is_face & (height > 0), i_first = share_i > share_j;
  BoxSide side{
      c,
      {{{select(is_before & !i_first, cj, c), select(is_before & !i_first, cij, ci), share_i, inverse_i * inverse_i},
        {select(is_before & i_first, ci, c), select(is_before & i_first, cij, cj), share_j, inverse_j * inverse_j}}},
      minus(c, opposite)};
  const bool is_inside = is_before ? std::fabs(share_i - share_j) > least_share : share_i + share_j < 1 - least_share;
  side.is_certain = !is_face || (is_inside && (std::fabs(height) > sure || sure == 0));
  return side;
}

/// The axes along which the feature at the nearest corner extends.
HWY_INLINE ConvexFeature feature_of(const BesideBox& b) {
  const unsigned free = static_cast<unsigned>(b.is_before(0)) | static_cast<unsigned>(b.is_before(1)) << 1U |
                        static_cast<unsigned>(b.is_before(2)) << 2U;
  return box_feature_at[free][b.corner()];
}

/// A point that is certainly outside of the box.
[[maybe_unused]] HWY_NOINLINE OffsetCorePair<2, 1> cores_beside(const OneBall& a, const OneBlock& b,
                                                                const BesideBox& beside_b, bool& is_certain) {
  const BoxSide side = side_of(b, beside_b, a.centre);
  is_certain = side.is_certain;
  return {{a.centre, side.corner, side.edge, {side.beyond}, b.slack},
          a.radius,
          b.radius,
          a.centre,
          minus(a.centre, way_from(b, beside_b)),
          {},
          feature_of(beside_b)};
}

// A point inside.

HWY_INLINE OneVector face_normal(const Mat3& axes, std::size_t axis) {
  const auto column = [&](std::size_t k) {
    const int i = static_cast<int>(k % 3);
    return in_one(axes[0][i], axes[1][i], axes[2][i]);
  };
  const OneVector normal = cross(column(axis + 1), column(axis + 2));
  return scaled(1 / std::sqrt(first_of(dot(normal, normal))), normal);
}

/// The way of a core out of the box's, where one is certainly the shortest.
struct WayOut {
  OneVector from;      ///< the point of the core that is the deepest
  OneVector outwards;  ///< unit
  double depth = 0;
  double error = 0;
  ConvexFeature feature_a, feature_b;
  bool is_known = false;
};

/// How far the box reaches along a direction: it is told from the direction as it is rounded, so that sums of products
/// alone are off, by less than 2^-50 of the sizes, and corners by the slack.
HWY_INLINE double reach_along(const OneBlock& block, const OneVector& direction) {
  return first_of(dot(block.half, magnitudes_of(block.local(direction))));
}
HWY_INLINE double reach_error(const OneBlock& block, const OneVector& sizes) {
  return 0x1p-49 * first_of(sum_of(plus(sizes, block.half))) + block.slack;
}

/// The face's normal towards the side on which the number is positive.
HWY_INLINE OneVector outward_normal(const OneBlock& block, std::size_t axis, double side) {
  const OneVector normal = face_normal(block.axes, axis);
  return (numbers_of(block.local(normal))[axis] > 0) == (side > 0) ? normal : negative(normal);
}

/// The way of a point out of the box, through the face that is seen to be the nearest; the other five are farther by
/// more than the frame is off.
[[maybe_unused]] HWY_NOINLINE WayOut way_out(const OneBlock& block, const BesideBox& b, const OneVector& point,
                                             const OneVector& from_centre) {
  const std::size_t k = b.across;
  const bool is_beside = std::fabs(b.at[k]) > 4 * b.error, is_within = b.beyond[k] < -4 * b.error;
  bool is_least = is_beside & is_within;
  for (std::size_t other = 0; other < 3; ++other)
    is_least = is_least & ((other == k) | (b.beyond[other] < b.beyond[k] - 4 * b.error));
  WayOut way;
  way.from = point;
  way.outwards = outward_normal(block, k, b.at[k]);
  way.depth = reach_along(block, way.outwards) - first_of(dot(way.outwards, from_centre));
  way.error = reach_error(block, magnitudes_of(from_centre));
  way.feature_a = only_vertex;
  way.feature_b = box_feature_at[7U ^ 1U << k][b.corner()];
  way.is_known = is_least;
  return way;
}

// A segment beside a box.

/// Half of the derivative of the squared distance from the box, in its frame, for the point at + t · way: grows with t,
/// and is linear between the places at which the way passes a face's plane.
struct SlopeAlong {
  ThreeNumbers at, way, half;

  template <class N>
  [[nodiscard]] HWY_INLINE N operator()(const N& t) const {
    const auto part = [&](std::size_t k) {
      const N x = hn::Add(all<N>(at[k]), hn::Mul(t, all<N>(way[k])));
      return hn::Mul(all<N>(way[k]), hn::Sub(x, clamped_between(x, all<N>(-half[k]), all<N>(half[k]))));
    };
    return hn::Add(hn::Add(part(0), part(1)), part(2));
  }
};

/// The share of the way at which it is nearest: the slopes at all six places and at both ends tell between which two it
/// changes its sign.
HWY_INLINE double nearest_share(const SlopeAlong& slope) {
  alignas(64) double place[8];
  for (std::size_t k = 0; k < 3; ++k) {
    const double inverse = 1 / slope.way[k];
    place[2 * k] = (-slope.half[k] - slope.at[k]) * inverse;
    place[2 * k + 1] = (slope.half[k] - slope.at[k]) * inverse;
  }
  place[6] = 0;
  place[7] = 1;
  constexpr std::size_t lanes = hn::MaxLanes(tag);
  const Number none = all(HUGE_VAL), zero = hn::Zero(tag), one = all(1);
  Number low = hn::Neg(none), high = none, low_slope = hn::Neg(none), high_slope = none;
  for (std::size_t part = 0; part < 8; part += lanes) {
    const Number t = hn::Load(tag, place + part), here = slope(t);
    const Mask within = hn::And(hn::Ge(t, zero), hn::Le(t, one));  // not NaN
    const Mask down = hn::And(within, hn::Lt(here, zero)), up = hn::And(within, hn::Ge(here, zero));
    low = greater(low, hn::IfThenElse(down, t, hn::Neg(none)));
    low_slope = greater(low_slope, hn::IfThenElse(down, here, hn::Neg(none)));
    high = lesser(high, hn::IfThenElse(up, t, none));
    high_slope = lesser(high_slope, hn::IfThenElse(up, here, none));
  }
  const double from = hn::GetLane(hn::MaxOfLanes(tag, low)), to = hn::GetLane(hn::MinOfLanes(tag, high));
  if (!(from >= 0)) return 0;
  if (!(to <= 1)) return 1;
  const double falls = hn::GetLane(hn::MaxOfLanes(tag, low_slope)),
               rises = hn::GetLane(hn::MinOfLanes(tag, high_slope));
  return clamped_to_share(from - falls * ((to - from) / (rises - falls)));
}

/// The nearest point of a segment, beside a box.
struct RodBesideBox {
  BesideBox nearest;
  ThreeNumbers way;
  double share = 0;
  double least_squared = 0;  ///< the squared distance is no less than this, but for `nearest.error`
};

/// By the slope that is left, no point along the segment can be nearer than it tells: the squared distance is convex.
/// Products are off by less than 2^-47 of the square of the sizes.
HWY_INLINE RodBesideBox beside(const OneRod& a, const OneBlock& b) {
  const OneVector from = minus(a.start, b.centre), along = minus(a.end, a.start);
  const OneVector local = b.local(from), way = b.local(along);
  const SlopeAlong slope{numbers_of(local), numbers_of(way), numbers_of(b.half)};
  RodBesideBox rod{{}, slope.way, nearest_share(slope)};
  const double error = local_frame_error(b, plus(magnitudes_of(from), magnitudes_of(along)));
  rod.nearest = beside(plus(local, scaled(rod.share, way)), b.half, error);
  const double left = first_of(slope(all<OneNumber>(rod.share)));
  const double down = rod.share > 0 ? left : 0, up = rod.share < 1 ? -left : 0;
  const double violation = down > up ? down : up;
  const double size = first_of(sum_of(plus(plus(magnitudes_of(local), magnitudes_of(way)), b.half)));
  rod.least_squared = rod.nearest.squared - 2 * (violation > 0 ? violation : 0) - 0x1p-46 * (size * size);
  return rod;
}

/// From within the segment, an edge of the box or a corner is seen.
HWY_INLINE OffsetCorePair<2, 2> cores_within(const OneRod& a, const OneBlock& b, const RodBesideBox& rod,
                                             bool& is_certain) {
  const BesideBox& at = rod.nearest;
  std::size_t k = at.beyond[1] < at.beyond[0] ? 1 : 0;
  k = at.beyond[2] < at.beyond[k] ? 2 : k;
  const std::size_t m = k == 2 ? 0 : k + 1, n = k == 0 ? 2 : k - 1;
  const Index first = at.corner();
  const OneVector c = b.corner(first), end = b.corner(first ^ Index{1} << k), along = minus(a.end, a.start);
  const double inverse = 0.5 / at.half[k];
  is_certain = !at.is_before(m) && !at.is_before(n);
  const OneVector on_a = plus(a.start, scaled(rod.share, along));
  return {{a.start,
           c,
           {{{a.end, a.start, rod.share, 1 / first_of(dot(along, along))}, {c, end, at.share(k), inverse * inverse}}},
           {minus(c, b.corner(first ^ Index{1} << m)), minus(c, b.corner(first ^ Index{1} << n))},
           b.slack},
          a.radius,
          b.radius,
          on_a,
          minus(on_a, way_from(b, at)),
          only_edge,
          feature_of(at)};
}

HWY_INLINE OffsetCorePair<2, 2> cores_at_end(const OneRod& a, const OneBlock& b, const RodBesideBox& rod,
                                             bool& is_certain) {
  const bool at_end = rod.share >= 1;
  const OneVector point = select(at_end, a.end, a.start), other = select(at_end, a.start, a.end);
  const BoxSide side = side_of(b, rod.nearest, point);
  is_certain = side.is_certain;
  return {{point, side.corner, side.edge, {side.beyond, minus(other, point)}, b.slack},
          a.radius,
          b.radius,
          point,
          minus(point, way_from(b, rod.nearest)),
          feature_at(rod.share),
          feature_of(rod.nearest)};
}

/// The segment does not reach the box.
[[maybe_unused]] HWY_NOINLINE OffsetCorePair<2, 2> cores_beside(const OneRod& a, const OneBlock& b,
                                                                const RodBesideBox& rod, bool& is_certain) {
  if (rod.share > 0 && rod.share < 1) return cores_within(a, b, rod, is_certain);
  return cores_at_end(a, b, rod, is_certain);
}

// A segment that reaches into a box: it leaves through a face, or across an edge of the box. These are all facets that
// the difference of the two has.

/// Depths along the six axes in the box's frame, of which all but the least are only compared with that.
struct RodAxes {
  std::array<double, 6> depth;    ///< of the faces, then of the edges
  std::array<double, 6> side;     ///< its sign tells to which side the segment leaves
  double least_sine_squared = 1;  ///< of the angle between the segment and an edge
  std::size_t least = 0;
  double next = HUGE_VAL;  ///< the depth but for the least
};

HWY_INLINE RodAxes axes_of_rod(const ThreeNumbers& at, const ThreeNumbers& way, const ThreeNumbers& half) {
  RodAxes axes;
  const double squared = (way[0] * way[0] + way[1] * way[1]) + way[2] * way[2];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t m = k == 2 ? 0 : k + 1, n = k == 0 ? 2 : k - 1;
    const double end = at[k] + way[k], low = at[k] < end ? at[k] : end, high = at[k] < end ? end : at[k];
    axes.side[k] = low + high;
    axes.depth[k] = low + high > 0 ? half[k] - low : half[k] + high;
    const double across = way[m] * way[m] + way[n] * way[n], offset = way[m] * at[n] - way[n] * at[m];
    axes.side[3 + k] = offset;
    axes.depth[3 + k] =
        ((half[m] * std::fabs(way[n]) + half[n] * std::fabs(way[m])) - std::fabs(offset)) / std::sqrt(across);
    axes.least_sine_squared = std::fmin(axes.least_sine_squared, across / squared);
  }
  for (std::size_t i = 1; i < 6; ++i) axes.least = axes.depth[i] < axes.depth[axes.least] ? i : axes.least;
  for (std::size_t i = 0; i < 6; ++i)
    axes.next = i != axes.least && axes.depth[i] < axes.next ? axes.depth[i] : axes.next;
  return axes;
}

/// Through a face with the end that is deeper by enough to be the only one.
HWY_INLINE WayOut way_through_face(const OneRod& a, const OneBlock& b, std::size_t axis, double side) {
  WayOut way;
  way.outwards = outward_normal(b, axis, side);
  const OneVector start = minus(a.start, b.centre), end = minus(a.end, b.centre);
  const double at_start = first_of(dot(way.outwards, start)), at_end = first_of(dot(way.outwards, end));
  const bool starts = at_start < at_end;
  way.from = select(starts, a.start, a.end);
  way.depth = reach_along(b, way.outwards) - (starts ? at_start : at_end);
  way.error = reach_error(b, plus(magnitudes_of(start), magnitudes_of(end)));
  way.is_known = std::fabs(at_end - at_start) > 0x1p-20 * (way.depth + std::fabs(at_start));
  return way;
}

/// Across an edge: the point of the segment is the one that is nearest to the edge's line.
HWY_INLINE WayOut way_across_edge(const OneRod& a, const OneBlock& b, std::size_t axis, double sine_squared) {
  const int k = static_cast<int>(axis);
  const OneVector edge = in_one(b.axes[0][k], b.axes[1][k], b.axes[2][k]), along = minus(a.end, a.start),
                  from = minus(a.start, b.centre), normal = cross(edge, along);
  WayOut way;
  const double turn = first_of(dot(normal, from)) < 0 ? -1 : 1;
  way.outwards = scaled(turn / std::sqrt(first_of(dot(normal, normal))), normal);
  const double at_start = first_of(dot(way.outwards, from)),
               at_end = first_of(dot(way.outwards, minus(a.end, b.centre)));
  way.depth = reach_along(b, way.outwards) - (at_start < at_end ? at_start : at_end);
  const OneVector sizes = plus(magnitudes_of(from), magnitudes_of(along));
  way.error = reach_error(b, sizes) * (1 + 1 / std::sqrt(sine_squared));
  // The edge's line passes through this, seen from the centre.
  ThreeNumbers to_edge = numbers_of(b.local(way.outwards));
  const ThreeNumbers half = numbers_of(b.half);
  for (std::size_t i = 0; i < 3; ++i) to_edge[i] = i == axis ? 0 : std::copysign(half[i], to_edge[i]);
  const OneVector beside = minus(b.turned(in_one(to_edge[0], to_edge[1], to_edge[2])), from),
                  across = minus(along, scaled(first_of(dot(along, edge)), edge));
  const double share = clamped_to_share(first_of(dot(beside, across)) / first_of(dot(across, across)));
  way.from = plus(a.start, scaled(share, along));
  way.is_known = true;
  return way;
}

/// Along the axis that is the least in the frame, which is off by 2^-40 of the sizes over the sine; the other five are
/// deeper by more than that.
[[maybe_unused]] HWY_NOINLINE WayOut way_out(const OneRod& a, const OneBlock& b, const RodBesideBox& rod) {
  const ThreeNumbers local = numbers_of(b.local(minus(a.start, b.centre)));
  const RodAxes axes = axes_of_rod(local, rod.way, rod.nearest.half);
  const bool is_face = axes.least < 3;
  WayOut way = is_face ? way_through_face(a, b, axes.least, axes.side[axes.least])
                       : way_across_edge(a, b, axes.least - 3, axes.least_sine_squared);
  const double margin = 512 * rod.nearest.error;
  const bool is_least = axes.next > axes.depth[axes.least] + margin,
             is_beside = std::fabs(axes.side[axes.least]) > (is_face ? margin : 0);
  way.is_known = way.is_known & (axes.least_sine_squared > 0x1p-12) & is_least & is_beside;
  return way;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#endif
