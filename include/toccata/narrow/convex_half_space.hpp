#pragma once

#include "toccata/narrow/convex_convex.hpp"

// A half-space and a bounded convex shape, or two half-spaces.
namespace toccata {

/// A half-space at its place: all world points p with (p − point) · normal ≤ 0, for the world point and the rotated
/// normal as rounded (docs/truth.md).
struct PosedHalfSpace {
  Vec3 point;
  Vec3 normal;

  /// Throws Error when the pose is not finite or deforms (as for a sphere), or a rounded number is not finite, or the
  /// normal becomes zero.
  explicit PosedHalfSpace(const HalfSpace& shape, const Pose& pose = {});
};

[[nodiscard]] bool overlap(const PosedPolytope& a, const PosedHalfSpace& b);
[[nodiscard]] bool overlap(const PosedHalfSpace& a, const PosedHalfSpace& b);

[[nodiscard]] Distance distance(const PosedPolytope& a, const PosedHalfSpace& b);
[[nodiscard]] Distance distance(const PosedHalfSpace& a, const PosedHalfSpace& b);

[[nodiscard]] Relation relation(const PosedPolytope& a, const PosedHalfSpace& b);
[[nodiscard]] Relation relation(const PosedHalfSpace& a, const PosedHalfSpace& b);

/// Throws Error when the convex shape is a surface.
[[nodiscard]] Penetration penetration(const PosedPolytope& a, const PosedHalfSpace& b);

[[nodiscard]] Manifold manifold(const PosedPolytope& a, const PosedHalfSpace& b);

}  // namespace toccata
