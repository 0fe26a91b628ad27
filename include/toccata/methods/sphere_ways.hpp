#pragma once

#include "toccata/narrow/posed_shapes.hpp"

namespace toccata {

// The lecture's ways to test a sphere against a triangle ("Special collision cases", CS679, University of Wisconsin,
// 2003). Each gives the exact answer by itself, and first asks `plane_rejects`; the others are its oracles.

/// The sphere does not reach the triangle's plane: apart. A triangle without area has no plane and is never rejected.
[[nodiscard]] bool plane_rejects(const PosedSphere& a, const Triangle& b);

/// The centre's foot on the plane, and the nearest point to it within the plane, in two dimensions.
[[nodiscard]] bool overlap_by_plane_projection(const PosedSphere& a, const Triangle& b);

/// The face if the foot is on it, each edge if the foot on its line is on it, and each vertex.
[[nodiscard]] bool overlap_by_features(const PosedSphere& a, const Triangle& b);

/// The nearest point by minimisation: a simplex of vertices that grows downhill until no vertex is nearer (P. Wolfe,
/// "Finding the nearest point in a polytope", 1976).
[[nodiscard]] bool overlap_by_minimisation(const PosedSphere& a, const Triangle& b);

/// The Voronoi region that the centre is in: of a vertex, an edge or the face; planes shared between regions are tested
/// once (section 5.1.5).
[[nodiscard]] bool overlap_by_voronoi_regions(const PosedSphere& a, const Triangle& b);

// A sphere and a box along the world's axes, from `lower` to `upper` (not greater in any coordinate): exact.

/// The sides of the six face planes that a point lies beyond, a bit each: 1: x < lower.x, 2: x > upper.x, 4 and 8 for
/// y, 16 and 32 for z. Only 27 of the 64 codes occur, one per region: no bit is inside, one a face's region, two an
/// edge's, three a corner's.
[[nodiscard]] constexpr unsigned box_region(const Vec3& p, const Vec3& lower, const Vec3& upper) {
  unsigned code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto shift = static_cast<unsigned>(2 * axis);
    code |= (p[axis] < lower[axis] ? 1U : 0U) << shift | (p[axis] > upper[axis] ? 2U : 0U) << shift;
  }
  return code;
}

/// Decides by the region of the centre: the nearest feature is that region's.
[[nodiscard]] bool overlap_by_regions(const PosedSphere& a, const Vec3& lower, const Vec3& upper);

/// Decides without a branch: max(lower − c, 0, c − upper) along each axis.
[[nodiscard]] bool overlap_by_clamping(const PosedSphere& a, const Vec3& lower, const Vec3& upper);

}  // namespace toccata
