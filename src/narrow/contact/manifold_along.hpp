#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// The points of a contact along a direction that is given, unit, from A to B, and not the shortest way to part the
/// two: where what they turn to each other lies over each other, seen along it. Empty where it does not, and where
/// neither turns a face or a line that way.
[[nodiscard]] Manifold manifold_along(const PosedPolytope& a, const PosedPolytope& b, const Vec3& direction);

/// The same for a quadric and a triangle.
[[nodiscard]] Manifold manifold_along(const PosedQuadric& a, const PosedPolytope& triangle, const Vec3& direction);

/// How far A reaches along a unit direction beyond where B begins, rounded.
[[nodiscard]] double overlap_along(const PosedPolytope& a, const PosedPolytope& b, const Vec3& direction);
[[nodiscard]] double overlap_along(const PosedQuadric& a, const PosedPolytope& b, const Vec3& direction);

}  // namespace toccata
