// Depths and contact points, one pair at a time.
// Compiled once for every SIMD level; Highway includes this file into itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "narrow/primitives/one_depth.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "narrow/convex/convex_of.hpp"
#include "narrow/primitives/offset_core_pair.hpp"
#include "toccata/narrow/primitives.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata {
namespace HWY_NAMESPACE {

Penetration depth_of_points(const PosedSphere& a, const PosedSphere& b) { return depth_for(in_world(a), in_world(b)); }
Penetration depth_of_point_segment(const PosedSphere& a, const PosedCapsule& b) {
  return depth_for(in_world(a), in_world(b));
}
Penetration depth_of_segments(const PosedCapsule& a, const PosedCapsule& b) {
  return depth_for(in_world(a), in_world(b));
}

Penetration depth_of_spheres(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return unknown_depth();
  return depth_for(in_world(a, pose_a), in_world(b, pose_b));
}
Penetration depth_of_sphere_capsule(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return unknown_depth();
  return depth_for(in_world(a, pose_a), in_world(b, pose_b));
}
Penetration depth_of_capsules(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return unknown_depth();
  return depth_for(in_world(a, pose_a), in_world(b, pose_b));
}

Manifold manifold_of_points(const PosedSphere& a, const PosedSphere& b) {
  return manifold_for(in_world(a), in_world(b));
}
Manifold manifold_of_point_segment(const PosedSphere& a, const PosedCapsule& b) {
  return manifold_for(in_world(a), in_world(b));
}
Manifold manifold_of_segments(const PosedCapsule& a, const PosedCapsule& b) {
  return manifold_for(in_world(a), in_world(b));
}

Manifold manifold_of_spheres(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return unknown_manifold();
  return manifold_for(in_world(a, pose_a), in_world(b, pose_b));
}
Manifold manifold_of_sphere_capsule(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return unknown_manifold();
  return manifold_for(in_world(a, pose_a), in_world(b, pose_b));
}
Manifold manifold_of_capsules(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  if (!are_rigid(pose_a, pose_b)) return unknown_manifold();
  return manifold_for(in_world(a, pose_a), in_world(b, pose_b));
}

}  // namespace HWY_NAMESPACE
}  // namespace toccata
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(depth_of_points);
HWY_EXPORT(depth_of_point_segment);
HWY_EXPORT(depth_of_segments);
HWY_EXPORT(manifold_of_points);
HWY_EXPORT(manifold_of_point_segment);
HWY_EXPORT(manifold_of_segments);
HWY_EXPORT(depth_of_spheres);
HWY_EXPORT(depth_of_sphere_capsule);
HWY_EXPORT(depth_of_capsules);
HWY_EXPORT(manifold_of_spheres);
HWY_EXPORT(manifold_of_sphere_capsule);
HWY_EXPORT(manifold_of_capsules);

Penetration formula_depth(const PosedSphere& a, const PosedSphere& b) {
  return HWY_DYNAMIC_DISPATCH(depth_of_points)(a, b);
}
Penetration formula_depth(const PosedSphere& a, const PosedCapsule& b) {
  return HWY_DYNAMIC_DISPATCH(depth_of_point_segment)(a, b);
}
Penetration formula_depth(const PosedCapsule& a, const PosedCapsule& b) {
  return HWY_DYNAMIC_DISPATCH(depth_of_segments)(a, b);
}

Manifold formula_manifold(const PosedSphere& a, const PosedSphere& b) {
  return HWY_DYNAMIC_DISPATCH(manifold_of_points)(a, b);
}
Manifold formula_manifold(const PosedSphere& a, const PosedCapsule& b) {
  return HWY_DYNAMIC_DISPATCH(manifold_of_point_segment)(a, b);
}
Manifold formula_manifold(const PosedCapsule& a, const PosedCapsule& b) {
  return HWY_DYNAMIC_DISPATCH(manifold_of_segments)(a, b);
}

// The formula's answer, or that of the general way.

Penetration penetration(const PosedSphere& a, const PosedSphere& b) {
  Penetration found = formula_depth(a, b);
  if (!is_known(found)) found = penetration(convex_of(a), convex_of(b));
  return found;
}
Penetration penetration(const PosedSphere& a, const PosedCapsule& b) {
  Penetration found = formula_depth(a, b);
  if (!is_known(found)) found = penetration(convex_of(a), convex_of(b));
  return found;
}
Penetration penetration(const PosedCapsule& a, const PosedCapsule& b) {
  Penetration found = formula_depth(a, b);
  if (!is_known(found)) found = penetration(convex_of(a), convex_of(b));
  return found;
}

Manifold manifold(const PosedSphere& a, const PosedSphere& b) {
  Manifold found = formula_manifold(a, b);
  if (!is_known(found)) found = manifold(convex_of(a), convex_of(b));
  return found;
}
Manifold manifold(const PosedSphere& a, const PosedCapsule& b) {
  Manifold found = formula_manifold(a, b);
  if (!is_known(found)) found = manifold(convex_of(a), convex_of(b));
  return found;
}
Manifold manifold(const PosedCapsule& a, const PosedCapsule& b) {
  Manifold found = formula_manifold(a, b);
  if (!is_known(found)) found = manifold(convex_of(a), convex_of(b));
  return found;
}

// Not known, they are posed, which throws where a pose is not allowed.

Penetration penetration(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b) {
  Penetration found = HWY_DYNAMIC_DISPATCH(depth_of_spheres)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = penetration(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
Penetration penetration(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  Penetration found = HWY_DYNAMIC_DISPATCH(depth_of_sphere_capsule)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = penetration(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
Penetration penetration(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  Penetration found = HWY_DYNAMIC_DISPATCH(depth_of_capsules)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = penetration(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}

Manifold manifold(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b) {
  Manifold found = HWY_DYNAMIC_DISPATCH(manifold_of_spheres)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = manifold(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
Manifold manifold(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  Manifold found = HWY_DYNAMIC_DISPATCH(manifold_of_sphere_capsule)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = manifold(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}
Manifold manifold(const Capsule& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b) {
  Manifold found = HWY_DYNAMIC_DISPATCH(manifold_of_capsules)(a, pose_a, b, pose_b);
  if (!is_known(found)) found = manifold(PosedPolytope(a, pose_a), PosedPolytope(b, pose_b));
  return found;
}

}  // namespace toccata
#endif
