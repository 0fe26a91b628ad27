// Depths and contact points of a ball or a capsule and a box, one pair at a time.
// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/primitives/one_box_depth.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "narrow/convex/convex_of.hpp"
#include "narrow/primitives/box_cores.hpp"
#include "toccata/narrow/primitives.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {
namespace {

/// What the box's frame tells alone.
struct FrameContact {
  bool is_apart = false;    ///< certainly
  bool is_outside = false;  ///< the other's core does not reach the box
};

/// `least_squared` is a lower bound of the squared distance, but for the error.
HWY_INLINE FrameContact frame_contact(const BesideBox& at, double least_squared, double reach) {
  const double outer = reach + at.error;
  const bool is_apart = (least_squared > more_square * (outer * outer)) & (least_squared < 0x1p1000);
  return {is_apart, at.beyond[at.across] > at.error};
}

/// For shapes that are apart: the way across the gap, rounded.
HWY_INLINE Penetration across_gap(const OneVector& on_a, double radius_a, const OneBlock& b, const BesideBox& at) {
  const OneVector way = way_from(b, at), direction = scaled(-1 / std::sqrt(first_of(dot(way, way))), way);
  Penetration result;
  store(direction, result.direction);
  store(plus(on_a, scaled(radius_a, direction)), result.on_a);
  store(minus(minus(on_a, way), scaled(b.radius, direction)), result.on_b);
  return result;
}

/// Where a core reaches into the box's.
HWY_INLINE Penetration depth_within(const WayOut& way, double radius_a, double radius_b) {
  const double least = ((way.depth - way.error) + radius_a) + radius_b,
               most = ((way.depth + way.error) + radius_a) + radius_b;
  Penetration result;
  result.lower = least - 0x1p-51 * least;
  result.upper = most + 0x1p-49 * most;
  if (!(way.is_known & (way.depth > way.error) & (result.upper - result.lower <= 0x1p-40 * result.upper)))
    return unknown_depth();
  const OneVector direction = negative(way.outwards);
  store(direction, result.direction);
  store(plus(way.from, scaled(radius_a, direction)), result.on_a);
  store(plus(way.from, scaled(way.depth + radius_b, way.outwards)), result.on_b);
  return result;
}

/// Rounding of its corners has not made it flat: a flat box can only touch.
HWY_INLINE bool is_thick(const OneBlock& b) {
  const ThreeNumbers half = numbers_of(b.half);
  return half[0] > 4 * b.slack && half[1] > 4 * b.slack && half[2] > 4 * b.slack;
}

// The answers for a core that does not reach the box's. These are called, and not compiled again into each that asks.

template <class Core, class Beside>
HWY_NOINLINE Penetration depth_outside(const Core& a, const OneBlock& b, const Beside& beside) {
  bool is_certain = false;
  const auto cores = cores_beside(a, b, beside, is_certain);
  Penetration depth = depth_of(cores);
  if (!is_certain) depth = unknown_depth();
  return depth;
}

template <class Core, class Beside>
HWY_NOINLINE Distance distance_outside(const Core& a, const OneBlock& b, const Beside& beside) {
  bool is_certain = false;
  const auto cores = cores_beside(a, b, beside, is_certain);
  Distance distance = distance_of(cores);
  if (!is_certain) distance = unknown_distance();
  return distance;
}

template <class Core, class Beside>
HWY_NOINLINE Manifold manifold_outside(const Core& a, const OneBlock& b, const Beside& beside) {
  bool is_certain = false;
  const auto cores = cores_beside(a, b, beside, is_certain);
  Manifold manifold = manifold_of(cores);
  if (!is_certain) manifold = unknown_manifold();
  return manifold;
}

HWY_INLINE Penetration depth_for(const OneBall& a, const OneBlock& b) {
  if (!is_thick(b)) return unknown_depth();
  const OneVector from = minus(a.centre, b.centre);
  const BesideBox at = beside(b.local(from), b.half, local_frame_error(b, from));
  const FrameContact contact = frame_contact(at, at.squared, a.radius + b.radius);
  if (contact.is_apart) return across_gap(a.centre, a.radius, b, at);
  if (!contact.is_outside) return depth_within(way_out(b, at, a.centre, from), a.radius, b.radius);
  return depth_outside(a, b, at);
}

HWY_INLINE Penetration depth_for(const OneRod& a, const OneBlock& b) {
  if (!is_thick(b)) return unknown_depth();
  const RodBesideBox rod = beside(a, b);
  const FrameContact contact = frame_contact(rod.nearest, rod.least_squared, a.radius + b.radius);
  if (contact.is_apart) {
    const OneVector on_a = plus(a.start, scaled(rod.share, minus(a.end, a.start)));
    return across_gap(on_a, a.radius, b, rod.nearest);
  }
  if (!contact.is_outside) return depth_within(way_out(a, b, rod), a.radius, b.radius);
  return depth_outside(a, b, rod);
}

// Distances.

HWY_INLINE Distance distance_for(const OneBall& a, const OneBlock& b) {
  const OneVector from = minus(a.centre, b.centre);
  const BesideBox at = beside(b.local(from), b.half, local_frame_error(b, from));
  if (!(at.beyond[at.across] > at.error)) return unknown_distance();
  return distance_outside(a, b, at);
}

/// Certainly, and by more than the frame is off.
HWY_INLINE bool meets(const RodBesideBox& rod, double reach) {
  const double inner = reach - rod.nearest.error;
  return inner > 0 && rod.nearest.squared < less_square * (inner * inner);
}

/// Of a segment that meets the box: a common point divides the way between the cores as the radii do.
HWY_INLINE Distance no_distance(const OneRod& a, const OneBlock& b, const RodBesideBox& rod) {
  const OneVector on_core = plus(a.start, scaled(rod.share, minus(a.end, a.start)));
  Distance distance;
  store(minus(on_core, scaled(a.radius / (a.radius + b.radius), way_from(b, rod.nearest))), distance.on_a);
  distance.on_b = distance.on_a;
  return distance;
}

HWY_INLINE Distance distance_for(const OneRod& a, const OneBlock& b) {
  const RodBesideBox rod = beside(a, b);
  if (meets(rod, a.radius + b.radius)) return no_distance(a, b, rod);
  if (!(rod.nearest.beyond[rod.nearest.across] > rod.nearest.error)) return unknown_distance();
  return distance_outside(a, b, rod);
}

// Contact points.

HWY_INLINE Manifold manifold_within(const WayOut& way, double radius_a, double radius_b) {
  if (!way.is_known) return unknown_manifold();
  Manifold result;
  result.count = 1;
  store(negative(way.outwards), result.normal);
  ManifoldPoint& point = result.points[0];
  store(plus(way.from, scaled(0.5 * ((way.depth + radius_b) - radius_a), way.outwards)), point.position);
  point.depth = way.depth + (radius_a + radius_b);
  point.on_a = way.feature_a;
  point.on_b = way.feature_b;
  return result;
}

HWY_INLINE Manifold manifold_for(const OneBall& a, const OneBlock& b) {
  if (!is_thick(b)) return unknown_manifold();
  const OneVector from = minus(a.centre, b.centre);
  const BesideBox at = beside(b.local(from), b.half, local_frame_error(b, from));
  const FrameContact contact = frame_contact(at, at.squared, a.radius + b.radius);
  if (contact.is_apart) return {};
  if (!contact.is_outside) return manifold_within(way_out(b, at, a.centre, from), a.radius, b.radius);
  return manifold_outside(a, b, at);
}

/// The other end of a segment, as far as it lies over the face, is so far from it that it is no point of the contact.
HWY_INLINE bool other_end_is_away(const RodBesideBox& rod, double reach) {
  const BesideBox& at = rod.nearest;
  const std::size_t m = at.across;
  const double turn = rod.share > 0 ? -1 : 1;
  double part = 1, squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double way = turn * rod.way[k], room = way > 0 ? at.half[k] - at.at[k] : at.half[k] + at.at[k];
    if (k != m && std::fabs(way) * part > room) part = room / std::fabs(way);
    squared += way * way;
  }
  const double rise = part * turn * rod.way[m] * (at.at[m] > 0 ? 1 : -1);
  const double depth = (reach - at.beyond[m]) - rise;
  return depth < -1.01 * gap_of_resting * part * std::sqrt(squared);
}

/// Contacts of a capsule that lies on a face, or nearly, have more points.
HWY_INLINE bool is_of_one_point(const RodBesideBox& rod, double reach) {
  const BesideBox& at = rod.nearest;
  int before = 0;
  for (std::size_t k = 0; k < 3; ++k) before += at.is_before(k) ? 1 : 0;
  if (before == 2) return (rod.share == 0 || rod.share == 1) && other_end_is_away(rod, reach);
  const double most = at.beyond[at.across];
  return most * most < 0.998 * cosine_of_face_contact * cosine_of_face_contact * at.squared;
}

HWY_INLINE Manifold manifold_for(const OneRod& a, const OneBlock& b) {
  if (!is_thick(b)) return unknown_manifold();
  const RodBesideBox rod = beside(a, b);
  const FrameContact contact = frame_contact(rod.nearest, rod.least_squared, a.radius + b.radius);
  if (contact.is_apart) return {};
  if (!contact.is_outside || !is_of_one_point(rod, a.radius + b.radius)) return unknown_manifold();
  return manifold_outside(a, b, rod);
}

HWY_INLINE Nearness nearness_for(const OneRod& a, const OneBlock& b) {
  const RodBesideBox rod = beside(a, b);
  const double reach = a.radius + b.radius, outer = reach + rod.nearest.error;
  if (meets(rod, reach)) return Nearness::meet;
  return rod.least_squared > more_square * (outer * outer) ? Nearness::apart : Nearness::unknown;
}

// Forms of a box. The same of each is asked, so that the bits are the same.

HWY_INLINE bool is_rigid(const Pose& pose) { return are_rigid(pose, pose); }

HWY_INLINE OneBlock in_world(const PosedBox& box) {
  return {box.pose.linear,
          in_one(box.rigid.centre),
          in_one(box.rigid.half_extents),
          box.rigid.slack,
          0,
          BlockCorners(box.shape, box.pose)};
}
HWY_INLINE OneBlock in_world(const PosedPolytope& box) {
  const RigidBox& rigid = box.as_box();
  return {box.pose().linear, in_one(rigid.centre), in_one(rigid.half_extents),
          rigid.slack,       box.radius(),         BlockCorners(box)};
}
HWY_INLINE const Pose& pose_of(const PosedBox& box) { return box.pose; }
HWY_INLINE const Pose& pose_of(const PosedPolytope& box) { return box.pose(); }

template <class A, class B>
HWY_INLINE Penetration depth_beside(const A& a, const B& b) {
  if (!is_rigid(pose_of(b))) return unknown_depth();
  return depth_for(in_world(a), in_world(b));
}
template <class A, class B>
HWY_INLINE Manifold manifold_beside(const A& a, const B& b) {
  if (!is_rigid(pose_of(b))) return unknown_manifold();
  return manifold_for(in_world(a), in_world(b));
}
template <class A, class B>
HWY_INLINE Distance distance_beside(const A& a, const B& b) {
  if (!is_rigid(pose_of(b))) return unknown_distance();
  return distance_for(in_world(a), in_world(b));
}

}  // namespace

Penetration depth_of_point_box(const PosedSphere& a, const PosedBox& b) { return depth_beside(a, b); }
Penetration depth_of_point_corners(const PosedSphere& a, const PosedPolytope& b) { return depth_beside(a, b); }
Penetration depth_of_segment_box(const PosedCapsule& a, const PosedBox& b) { return depth_beside(a, b); }
Penetration depth_of_segment_corners(const PosedCapsule& a, const PosedPolytope& b) { return depth_beside(a, b); }
Manifold manifold_of_point_box(const PosedSphere& a, const PosedBox& b) { return manifold_beside(a, b); }
Manifold manifold_of_point_corners(const PosedSphere& a, const PosedPolytope& b) { return manifold_beside(a, b); }
Manifold manifold_of_segment_box(const PosedCapsule& a, const PosedBox& b) { return manifold_beside(a, b); }
Manifold manifold_of_segment_corners(const PosedCapsule& a, const PosedPolytope& b) { return manifold_beside(a, b); }
Distance close_distance_of_point_box(const PosedSphere& a, const PosedBox& b) { return distance_beside(a, b); }
Distance close_distance_of_point_corners(const PosedSphere& a, const PosedPolytope& b) { return distance_beside(a, b); }
Distance close_distance_of_segment_box(const PosedCapsule& a, const PosedBox& b) { return distance_beside(a, b); }
Distance close_distance_of_segment_corners(const PosedCapsule& a, const PosedPolytope& b) {
  return distance_beside(a, b);
}

Penetration depth_of_sphere_box(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b) || !is_rigid(pose_b)) return unknown_depth();
  return depth_for(in_world(a, pose_a), in_world(b, pose_b));
}
Penetration depth_of_capsule_box(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b) || !is_rigid(pose_b)) return unknown_depth();
  return depth_for(in_world(a, pose_a), in_world(b, pose_b));
}
Manifold manifold_of_sphere_box(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b) || !is_rigid(pose_b)) return unknown_manifold();
  return manifold_for(in_world(a, pose_a), in_world(b, pose_b));
}
Manifold manifold_of_capsule_box(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b) || !is_rigid(pose_b)) return unknown_manifold();
  return manifold_for(in_world(a, pose_a), in_world(b, pose_b));
}
Distance close_distance_of_sphere_box(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b) || !is_rigid(pose_b)) return unknown_distance();
  return distance_for(in_world(a, pose_a), in_world(b, pose_b));
}
Distance close_distance_of_capsule_box(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b) || !is_rigid(pose_b)) return unknown_distance();
  return distance_for(in_world(a, pose_a), in_world(b, pose_b));
}
Nearness nearness_of_capsule_box(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b) || !is_rigid(pose_b)) return Nearness::unknown;
  return nearness_for(in_world(a, pose_a), in_world(b, pose_b));
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(depth_of_point_box);
HWY_EXPORT(depth_of_point_corners);
HWY_EXPORT(depth_of_segment_box);
HWY_EXPORT(depth_of_segment_corners);
HWY_EXPORT(manifold_of_point_box);
HWY_EXPORT(manifold_of_point_corners);
HWY_EXPORT(manifold_of_segment_box);
HWY_EXPORT(manifold_of_segment_corners);
HWY_EXPORT(close_distance_of_point_box);
HWY_EXPORT(close_distance_of_point_corners);
HWY_EXPORT(close_distance_of_segment_box);
HWY_EXPORT(close_distance_of_segment_corners);
HWY_EXPORT(depth_of_sphere_box);
HWY_EXPORT(depth_of_capsule_box);
HWY_EXPORT(manifold_of_sphere_box);
HWY_EXPORT(manifold_of_capsule_box);
HWY_EXPORT(close_distance_of_sphere_box);
HWY_EXPORT(close_distance_of_capsule_box);
HWY_EXPORT(nearness_of_capsule_box);

Penetration formula_depth(const PosedSphere& a, const PosedPolytope& box) {
  return HWY_DYNAMIC_DISPATCH(depth_of_point_corners)(a, box);
}
Penetration formula_depth(const PosedCapsule& a, const PosedPolytope& box) {
  return HWY_DYNAMIC_DISPATCH(depth_of_segment_corners)(a, box);
}
Manifold formula_manifold(const PosedSphere& a, const PosedPolytope& box) {
  return HWY_DYNAMIC_DISPATCH(manifold_of_point_corners)(a, box);
}
Manifold formula_manifold(const PosedCapsule& a, const PosedPolytope& box) {
  return HWY_DYNAMIC_DISPATCH(manifold_of_segment_corners)(a, box);
}
Distance close_formula_distance(const PosedSphere& a, const PosedPolytope& box) {
  return HWY_DYNAMIC_DISPATCH(close_distance_of_point_corners)(a, box);
}
Distance close_formula_distance(const PosedCapsule& a, const PosedPolytope& box) {
  return HWY_DYNAMIC_DISPATCH(close_distance_of_segment_corners)(a, box);
}
Distance close_formula_distance(const PosedSphere& a, const PosedBox& b) {
  return HWY_DYNAMIC_DISPATCH(close_distance_of_point_box)(a, b);
}
Distance close_formula_distance(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  return HWY_DYNAMIC_DISPATCH(close_distance_of_sphere_box)(a, pose_a, b, pose_b);
}

// The formula's answer, or that of the general way.

Penetration penetration(const PosedSphere& a, const PosedBox& b) {
  Penetration found = HWY_DYNAMIC_DISPATCH(depth_of_point_box)(a, b);
  if (!is_known(found)) found = penetration(convex_of(a), convex_of(b));
  return found;
}
Penetration penetration(const PosedCapsule& a, const PosedBox& b) {
  Penetration found = HWY_DYNAMIC_DISPATCH(depth_of_segment_box)(a, b);
  if (!is_known(found)) found = penetration(convex_of(a), convex_of(b));
  return found;
}
Manifold manifold(const PosedSphere& a, const PosedBox& b) {
  Manifold found = HWY_DYNAMIC_DISPATCH(manifold_of_point_box)(a, b);
  if (!is_known(found)) found = manifold(convex_of(a), convex_of(b));
  return found;
}
Manifold manifold(const PosedCapsule& a, const PosedBox& b) {
  Manifold found = HWY_DYNAMIC_DISPATCH(manifold_of_segment_box)(a, b);
  if (!is_known(found)) found = manifold(convex_of(a), convex_of(b));
  return found;
}
Distance distance(const PosedCapsule& a, const PosedBox& b) {
  Distance found = HWY_DYNAMIC_DISPATCH(close_distance_of_segment_box)(a, b);
  if (!is_known(found)) found = distance(convex_of(a), convex_of(b));
  return found;
}

// Not known, they are posed, which throws where a pose is not allowed.

Penetration penetration(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  Penetration found = HWY_DYNAMIC_DISPATCH(depth_of_sphere_box)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = penetration(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
Penetration penetration(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  Penetration found = HWY_DYNAMIC_DISPATCH(depth_of_capsule_box)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = penetration(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
Manifold manifold(const Sphere& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  Manifold found = HWY_DYNAMIC_DISPATCH(manifold_of_sphere_box)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = manifold(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
Manifold manifold(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  Manifold found = HWY_DYNAMIC_DISPATCH(manifold_of_capsule_box)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = manifold(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
Distance distance(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  Distance found = HWY_DYNAMIC_DISPATCH(close_distance_of_capsule_box)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = distance(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
bool overlap(const Capsule& a, const Pose& pose_a, const Box& b, const Pose& pose_b) {
  const Nearness nearness = HWY_DYNAMIC_DISPATCH(nearness_of_capsule_box)(a, pose_a, b, pose_b);
  if (nearness != Nearness::unknown) return nearness == Nearness::meet;
  return overlap(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
}

}  // namespace toccata
#endif
