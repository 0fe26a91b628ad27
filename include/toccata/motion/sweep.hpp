#pragma once

#include "toccata/motion/rigid_motion.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// How a question about two models that move is asked.
struct SweepQuery {
  Solid solid_a = Solid::automatic;
  Solid solid_b = Solid::automatic;
  /// How near they may come, in world units: what is looked for is when they come as near as that. Negative: how deep
  /// two elements may be in each other, as what stands on a floor and walks. What is looked for is then when the
  /// shortest way to part two elements is longer; of meshes these are triangles, so that one within another counts when
  /// it comes to the surface. 0: the first common point.
  double stop_before = 0;
};

/// The first meeting of two models that move and turn; the times are those of the motions, from 0 to 1. Free is proved:
/// at no real time in [0, 1] have they a point in common. A hit has one of two statuses:
///
///   exact      nothing is met before `lower`, and at `upper` or before they have a point in common; both are proved
///   undecided  nothing is met before `lower`, when they come as near as rounding can tell of poses that turn, some
///              10⁻¹³ of their sizes; whether they touch or pass is not told, and `upper` is `lower`
///
/// What does not turn is answered by `cast_shape`. Of meshes, height fields and compounds it is the earliest of their
/// elements, by (upper, element of A, element of B); models that meet at the start are met at 0, with the two elements
/// that `distance` names. The normal is from B to A. Of a half-space and another nothing is asked, as in `cast_shape`.
/// Throws Error for what `overlap` throws for at the poses of the start, for a negative `stop_before`, for what the
/// table of pairs.hpp does not define of casts, and when a motion that is told by a function moved faster than its
/// bound.
[[nodiscard]] ShapeHit sweep(const Model& a, const RigidMotion& motion_a, const Model& b, const RigidMotion& motion_b,
                             const SweepQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] ShapeHit sweep(const Model& a, const RigidMotion& motion_a, const Model& b, const RigidMotion& motion_b,
                             const SweepQuery& query, Workspace& workspace);

/// Make a Model of it, once: `Model(mesh)`.
template <class A, class B>
requires NeedAModel<A, B> ShapeHit sweep(const A&, const RigidMotion&, const B&, const RigidMotion&,
                                         const SweepQuery& = {})
= delete;

}  // namespace toccata
