// One pair at a time, in the one lane of vectors: they select without a branch.
// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/primitives/one_distance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>

#include "narrow/boxes/box_corners.hpp"
#include "narrow/boxes/rigid_poses.hpp"
#include "narrow/convex/convex_of.hpp"
#include "narrow/primitives/offset_core_pair.hpp"
#include "narrow/primitives/offset_cores.hpp"
#include "narrow/primitives/pair_depths.hpp"
#include "narrow/primitives/pair_distances.hpp"
#include "narrow/triangles/one_lane.hpp"
#include "toccata/narrow/primitives.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

using OnePoint = OffsetPoint<OneVector>;
using OneSegment = OffsetSegment<OneVector>;
using OneNear = NearPoints<OneVector>;
using OneReached = Reached<OneVector>;
using OneFound = Found<OneVector>;

HWY_INLINE bool is_set(const OneMask& mask) { return hn::AllTrue(OneTag(), mask); }

/// The formula tells nothing.
HWY_INLINE OneFound nothing() {
  const OneVector none = in_one(0, 0, 0);
  return {hn::Zero(OneTag()), all<OneNumber>(std::numeric_limits<double>::quiet_NaN()), none, none};
}

/// The same as `found_of`, with branches: which of the three cases it is, is mostly foreseen, and nothing waits for it.
/// `common` gives the common point of cores that meet.
template <class Common>
HWY_INLINE OneFound foreseen(const OneNear& near, const OneNumber& radius_a, const OneNumber& radius_b,
                             const Common& common) {
  const OneReached how = reached(near, radius_a, radius_b);
  if (is_set(how.apart)) {
    const ReachedEnds<OneVector> ends = ends_of(near, how, radius_a, radius_b);
    return {how.lower, how.upper, ends.on_a, ends.on_b};
  }
  if (!is_set(how.meets)) return nothing();
  const OneVector point = common(how);
  return {hn::Zero(OneTag()), hn::Zero(OneTag()), point, point};
}

HWY_INLINE OneFound foreseen(const OneNear& near, const OneNumber& radius_a, const OneNumber& radius_b) {
  return foreseen(near, radius_a, radius_b, [&](const OneReached& how) { return common_point(near, how, radius_a); });
}

/// Made in one place, so that it is written once.
HWY_INLINE Distance answer_of(const OneFound& found) {
  Distance answer;
  answer.lower = first_of(found.lower);
  answer.upper = first_of(found.upper);
  store(found.on_a, answer.on_a);
  store(found.on_b, answer.on_b);
  return answer;
}

HWY_INLINE OneBall with_radius(const OnePoint& p) { return {p.centre, first_of(p.radius)}; }
HWY_INLINE OneRod with_radius(const OneSegment& s) { return {s.start, s.end, first_of(s.radius)}; }

/// With twice the digits, where doubles leave it open.
template <class A, class B>
HWY_INLINE Distance answer_of(const OneFound& found, const A& a, const B& b) {
  Distance answer = answer_of(found);
  if (!is_known(answer)) answer = distance_for(with_radius(a), with_radius(b));
  return answer;
}

// The eight corners of a box, one in each lane.

constexpr std::size_t corner_lanes = hn::MaxLanes(tag), corner_parts = 8 / corner_lanes;

/// 1 for each corner whose bit `axis` is set, or, in the second row, is not.
alignas(64) constexpr double corner_weight[2][3][8] = {
    {{0, 1, 0, 1, 0, 1, 0, 1}, {0, 0, 1, 1, 0, 0, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}},
    {{1, 0, 1, 0, 1, 0, 1, 0}, {1, 1, 0, 0, 1, 1, 0, 0}, {1, 1, 1, 1, 0, 0, 0, 0}}};

/// `rest_of_box`, of the corners as they are; the nearest one is number `nearest`.
struct RestOfCorners {
  const std::array<const double*, 3>& corner;
  std::size_t nearest;
  const std::array<OneVector, 3>& edge;

  HWY_INLINE BoxRest<OneVector> operator()(const OneVector& d) const;
};

HWY_INLINE BoxRest<OneVector> RestOfCorners::operator()(const OneVector& d) const {
  const auto coordinates = [](const OneVector& v) {
    return std::array<double, 3>{first_of(x_of(v)), first_of(y_of(v)), first_of(z_of(v))};
  };
  const std::array<double, 3> along = coordinates(d);
  const std::array<std::array<double, 3>, 3> edges{coordinates(edge[0]), coordinates(edge[1]), coordinates(edge[2])};
  Number lowest = hn::Zero(tag), bend = hn::Zero(tag);
  for (std::size_t part = 0; part < corner_parts; ++part) {
    Number height = hn::Zero(tag), size = hn::Zero(tag), bent = hn::Zero(tag);
#pragma GCC unroll 3
    for (std::size_t i = 0; i < 3; ++i) {
      const Number from_first =
          hn::Sub(hn::LoadU(tag, corner[i] + part * corner_lanes), hn::Set(tag, corner[i][nearest]));
      const Number product = hn::Mul(from_first, hn::Set(tag, along[i]));
      height = hn::Add(height, product);
      size = hn::Add(size, hn::Mul(hn::Abs(from_first), hn::Set(tag, std::fabs(along[i]))));
      Number rest = from_first;
#pragma GCC unroll 3
      for (std::size_t k = 0; k < 3; ++k) {
        const auto set = hn::Load(tag, corner_weight[nearest >> k & 1][k] + part * corner_lanes);
        rest = hn::Sub(rest, hn::Mul(set, hn::Set(tag, edges[k][i])));
      }
      bent = hn::Add(bent, hn::Abs(rest));
    }
    lowest = hn::Min(lowest, hn::Sub(height, hn::Mul(hn::Set(tag, 0x1p-51), size)));
    bend = hn::Max(bend, bent);
  }
  return {all<OneNumber>(hn::GetLane(hn::MinOfLanes(tag, lowest))),
          all<OneNumber>(hn::GetLane(hn::MaxOfLanes(tag, bend)))};
}

HWY_INLINE OneFound of_point_box(const OnePoint& a, const RoundBox& b) {
  const auto corner = [&](std::size_t i) { return in_one(b.corner[0][i], b.corner[1][i], b.corner[2][i]); };
  const OneVector& p = a.centre;
  const BoxSides<OneVector> sides = sides_of(p, corner(0), {corner(1), corner(2), corner(4)});
  std::size_t nearest = 0;
#pragma GCC unroll 3
  for (std::size_t axis = 0; axis < 3; ++axis) nearest |= std::size_t{is_set(sides.far[axis])} << axis;
  const OneVector first = corner(nearest);
  const BoxCorner<OneVector> at{
      first, {minus(corner(nearest ^ 1), first), minus(corner(nearest ^ 2), first), minus(corner(nearest ^ 4), first)}};
  return foreseen(near_of_point_corner(p, at, sides, RestOfCorners{b.corner, nearest, at.edge}), a.radius,
                  all<OneNumber>(b.radius));
}

/// `world_corners`, bit by bit.
HWY_INLINE void place_corners_at_once(const Box& box, const Pose& pose, BoxCorners& corners) {
  const Vec3 lower = box.centre() - box.half_extents(), upper = box.centre() + box.half_extents();
  for (std::size_t part = 0; part < corner_parts; ++part) {
    const auto local = [&](int axis) {
      const auto set = hn::Load(tag, corner_weight[0][axis] + part * corner_lanes);
      return hn::IfThenElse(hn::Gt(set, hn::Zero(tag)), hn::Set(tag, upper[axis]), hn::Set(tag, lower[axis]));
    };
    const auto x = local(0), y = local(1), z = local(2);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      const Vec3& row = pose.linear[i];
      const auto in_plane = hn::Add(hn::Mul(hn::Set(tag, row.x), x), hn::Mul(hn::Set(tag, row.y), y));
      const auto turned = hn::Add(in_plane, hn::Mul(hn::Set(tag, row.z), z));
      hn::Store(hn::Add(turned, hn::Set(tag, pose.offset[i])), tag,
                corners.coordinate[static_cast<std::size_t>(i)].data() + part * corner_lanes);
    }
  }
}

// The formulas, of shapes in the world.

HWY_INLINE OnePoint ball_of(const PosedSphere& s) { return {in_one(s.centre), all<OneNumber>(s.radius)}; }
HWY_INLINE OneSegment rod_of(const PosedCapsule& c) {
  return {in_one(c.start), in_one(c.end), all<OneNumber>(c.radius)};
}

struct OneTriangle {
  OneVector a, b, c;
};

HWY_INLINE OneFound found_for(const OnePoint& a, const OnePoint& b) {
  const OneNear near = near_of_points(a.centre, b.centre);
  return foreseen(near, a.radius, b.radius, [&](const OneReached& how) {
    if (is_set(comes_after(a.centre, b.centre))) return common_point(near_of_points(b.centre, a.centre), how, b.radius);
    return common_point(near, how, a.radius);
  });
}

HWY_INLINE OneFound found_for(const OnePoint& a, const OneSegment& b) {
  return foreseen(near_of_point_segment(a.centre, b.start, b.end), a.radius, b.radius);
}

HWY_INLINE OneFound found_for(const OnePoint& a, const OneTriangle& b, double radius_b) {
  return foreseen(near_of_point_triangle(a.centre, b.a, b.b, b.c), a.radius, all<OneNumber>(radius_b));
}

HWY_INLINE OneFound found_for(const OnePoint& a, const Box& b, const Pose& pose_b) {
  BoxCorners corners;
  place_corners_at_once(b, pose_b, corners);
  return of_point_box(a, {corners.along(), 0});
}

HWY_INLINE OneFound found_for(const OneSegment& a, const OneSegment& b) {
  OneMask exchange = hn::Lt(x_of(b.start), x_of(a.start));
  if (is_set(hn::Eq(x_of(b.start), x_of(a.start)))) {
    exchange = comes_after(a.start, b.start);
    if (!is_set(hn::Or(exchange, comes_after(b.start, a.start)))) return nothing();
  }
  const OneSegment first = chosen(exchange, b, a), second = chosen(exchange, a, b);
  const OneNear near = near_of_segments(first.start, first.end, second.start, second.end);
  return exchanged(exchange, foreseen(near, first.radius, second.radius));
}

// Shapes at their places, of poses that are known to be rigid.

HWY_INLINE OnePoint at_place(const Sphere& shape, const Pose& pose) {
  return {placed_in_one(pose, shape.centre()), all<OneNumber>(shape.radius())};
}
HWY_INLINE OneSegment at_place(const Capsule& shape, const Pose& pose) {
  const Placing placing(pose);
  return {placing(shape.start()), placing(shape.end()), all<OneNumber>(shape.radius())};
}
HWY_INLINE OneTriangle at_place(const Triangle& shape, const Pose& pose) {
  const Placing placing(pose);
  return {placing(shape[0]), placing(shape[1]), placing(shape[2])};
}

template <class A, class B>
HWY_INLINE Distance distance_of_round(const A& a, const B& b) {
  return answer_of(found_for(a, b), a, b);
}

}  // namespace

Distance points(const PosedSphere& a, const PosedSphere& b) { return distance_of_round(ball_of(a), ball_of(b)); }
Distance point_segment(const PosedSphere& a, const PosedCapsule& b) { return distance_of_round(ball_of(a), rod_of(b)); }
Distance point_triangle(const PosedSphere& a, const Triangle& b, double radius_b) {
  return answer_of(found_for(ball_of(a), {in_one(b[0]), in_one(b[1]), in_one(b[2])}, radius_b));
}
Distance point_corners(const PosedSphere& a, const RoundBox& b) { return answer_of(of_point_box(ball_of(a), b)); }
Distance point_box(const PosedSphere& a, const PosedBox& b) {
  return answer_of(found_for(ball_of(a), b.shape, b.pose));
}
Distance segments(const PosedCapsule& a, const PosedCapsule& b) { return distance_of_round(rod_of(a), rod_of(b)); }

// Where something is not finite, no interval is narrow, and nothing is told.

Distance distance_of_spheres(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return answer_of(nothing());
  return distance_of_round(at_place(a, pose_a), at_place(b, pose_b));
}

Distance distance_of_sphere_capsule(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return answer_of(nothing());
  return distance_of_round(at_place(a, pose_a), at_place(b, pose_b));
}

Distance distance_of_sphere_triangle(const Sphere& a, const Pose& pose_a, const Triangle& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return answer_of(nothing());
  return answer_of(found_for(at_place(a, pose_a), at_place(b, pose_b), 0));
}

Distance distance_of_sphere_box(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return answer_of(nothing());
  return answer_of(found_for(at_place(a, pose_a), b, pose_b));
}

Distance distance_of_capsules(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return answer_of(nothing());
  return distance_of_round(at_place(a, pose_a), at_place(b, pose_b));
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(points);
HWY_EXPORT(point_segment);
HWY_EXPORT(point_triangle);
HWY_EXPORT(point_corners);
HWY_EXPORT(point_box);
HWY_EXPORT(segments);
HWY_EXPORT(distance_of_spheres);
HWY_EXPORT(distance_of_sphere_capsule);
HWY_EXPORT(distance_of_sphere_triangle);
HWY_EXPORT(distance_of_sphere_box);
HWY_EXPORT(distance_of_capsules);

Distance formula_distance(const PosedSphere& a, const PosedSphere& b) { return HWY_DYNAMIC_DISPATCH(points)(a, b); }
Distance formula_distance(const PosedSphere& a, const PosedCapsule& b) {
  return HWY_DYNAMIC_DISPATCH(point_segment)(a, b);
}
Distance formula_distance(const PosedSphere& a, const Triangle& b, double radius_b) {
  return HWY_DYNAMIC_DISPATCH(point_triangle)(a, b, radius_b);
}
Distance formula_distance(const PosedSphere& a, const RoundBox& b) { return HWY_DYNAMIC_DISPATCH(point_corners)(a, b); }
Distance formula_distance(const PosedCapsule& a, const PosedCapsule& b) { return HWY_DYNAMIC_DISPATCH(segments)(a, b); }

// The formula's answer, or that of the search.

Distance distance(const PosedSphere& a, const PosedSphere& b) {
  Distance found = HWY_DYNAMIC_DISPATCH(points)(a, b);
  if (!is_known(found)) found = distance(convex_of(a), convex_of(b));
  return found;
}

Distance distance(const PosedSphere& a, const PosedCapsule& b) {
  Distance found = HWY_DYNAMIC_DISPATCH(point_segment)(a, b);
  if (!is_known(found)) found = distance(convex_of(a), convex_of(b));
  return found;
}

Distance distance(const PosedSphere& a, const Triangle& b) {
  Distance found = HWY_DYNAMIC_DISPATCH(point_triangle)(a, b, 0);
  if (!is_known(found)) found = distance(convex_of(a), convex_of(b));
  return found;
}

Distance distance(const PosedSphere& a, const PosedBox& b) {
  Distance found = HWY_DYNAMIC_DISPATCH(point_box)(a, b);
  if (!is_known(found)) found = close_formula_distance(a, b);
  if (!is_known(found)) found = distance(convex_of(a), convex_of(b));
  return found;
}

Distance distance(const PosedCapsule& a, const PosedCapsule& b) {
  Distance found = HWY_DYNAMIC_DISPATCH(segments)(a, b);
  if (!is_known(found)) found = distance(convex_of(a), convex_of(b));
  return found;
}

Distance distance(const PosedCapsule& a, const Segment& b) {
  Distance found = HWY_DYNAMIC_DISPATCH(segments)(a, {b.start(), b.end(), 0});
  if (!is_known(found)) found = distance(convex_of(a), convex_of(b));
  return found;
}

// Not known, they are posed, which throws where a pose is not allowed.

Distance distance(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b) {
  Distance found = HWY_DYNAMIC_DISPATCH(distance_of_spheres)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = distance(PosedSphere(a, pose_a), PosedSphere(b, pose_b));
  return found;
}

Distance distance(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  Distance found = HWY_DYNAMIC_DISPATCH(distance_of_sphere_capsule)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = distance(PosedSphere(a, pose_a), PosedCapsule(b, pose_b));
  return found;
}

Distance distance(const Sphere& a, const Pose& pose_a, const Triangle& b, const Pose& pose_b) {
  Distance found = HWY_DYNAMIC_DISPATCH(distance_of_sphere_triangle)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = distance(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}

Distance distance(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  Distance found = HWY_DYNAMIC_DISPATCH(distance_of_sphere_box)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = close_formula_distance(a, pose_a, b, pose_b);
  if (!is_known(found)) found = distance(PosedSphere(a, pose_a), PosedBox(b, pose_b));
  return found;
}

Distance distance(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  Distance found = HWY_DYNAMIC_DISPATCH(distance_of_capsules)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = distance(PosedCapsule(a, pose_a), PosedCapsule(b, pose_b));
  return found;
}

}  // namespace toccata
#endif
