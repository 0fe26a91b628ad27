#include "toccata/narrow/convex_convex.hpp"

#include "narrow/convex/convex_containment.hpp"
#include "narrow/half_spaces/half_space_heights.hpp"
#include "narrow/pose_checks.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

Pose without_offset(const Pose& pose) { return {pose.linear, {}}; }

/// The rounded normals are exact multiples of each other.
bool are_parallel(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d({}, drop_axis(a.normal, axis), drop_axis(b.normal, axis)) != Sign::zero) return false;
  return true;
}

/// Whether two half-spaces with parallel normals point the same way.
bool point_the_same_way(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (a.normal[axis] != 0) return (a.normal[axis] > 0) == (b.normal[axis] > 0);
  return true;
}

Containment containment_of_parallel(Sign height_of_a_above_b) {
  if (height_of_a_above_b == Sign::zero) return Containment::equal;
  return height_of_a_above_b == Sign::negative ? Containment::a_in_b : Containment::b_in_a;
}

}  // namespace

PosedHalfSpace::PosedHalfSpace(const HalfSpace& shape, const Pose& pose) {
  require_finite(pose, "the half-space");
  require_undeformed(pose, "the half-space");
  point = transform(pose, shape.point());
  normal = transform(without_offset(pose), shape.normal());
  if (!is_finite(point)) refuse_vertex(0, shape.point(), pose, "the half-space");
  if (!is_finite(normal)) throw Error("the half-space: its normal in the world is not finite; give a shorter normal");
  if (normal == Vec3{}) throw Error("the half-space: its normal vanishes in the world; give a longer normal");
}

bool overlap(const PosedPolytope& a, const PosedHalfSpace& b) {
  const ExtremeVertex lowest = extreme_vertex(a, b, Reach::below);
  return reach_sign(lowest.position, a.radius(), b, Reach::below) != Sign::negative;
}

bool overlap(const PosedHalfSpace& a, const PosedHalfSpace& b) { return relation(a, b).kind != RelationKind::apart; }

Relation relation(const PosedPolytope& a, const PosedHalfSpace& b) {
  Relation result;
  result.a_solid = a.solid();
  result.b_solid = true;
  const ExtremeVertex lowest = extreme_vertex(a, b, Reach::below);
  const Sign below = reach_sign(lowest.position, a.radius(), b, Reach::below);
  if (below == Sign::negative) return result;
  result.kind = RelationKind::touching;
  if (below == Sign::zero || is_flattened(a)) return result;
  result.kind = a.solid() ? RelationKind::overlapping : RelationKind::crossing;
  const ExtremeVertex highest = extreme_vertex(a, b, Reach::above);
  const Sign above = reach_sign(highest.position, a.radius(), b, Reach::above);
  // A surface has to lie in the interior.
  if (above == Sign::negative || (above == Sign::zero && a.solid())) result.containment = Containment::a_in_b;
  return result;
}

Relation relation(const PosedHalfSpace& a, const PosedHalfSpace& b) {
  Relation result;
  result.a_solid = result.b_solid = true;
  result.kind = RelationKind::overlapping;
  if (!are_parallel(a, b)) return result;
  const Sign height = height_sign(b, a.point);
  if (point_the_same_way(a, b)) {
    result.containment = containment_of_parallel(height);
    return result;
  }
  if (height == Sign::positive) result.kind = RelationKind::apart;
  if (height == Sign::zero) result.kind = RelationKind::touching;
  return result;
}

}  // namespace toccata
