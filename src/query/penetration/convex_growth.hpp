#pragma once

#include <array>
#include <optional>
#include <vector>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// Which plane cuts a triangle off: the one across the way to its nearest point, or its own, which of a convex solid
/// leaves all.
enum class CutBy { nearest_point, own_plane };

/// A triangle as seen from a point, and where it is nearest to it.
struct Obstacle {
  std::array<Vec3, 3> corner;
  Vec3 nearest;
  double squared;
};

/// The triangles that meet the cube of half-edge `reach` around the point, nearest first.
struct Surroundings {
  Vec3 point;
  double reach = 0;
  std::vector<Obstacle> obstacles;
};

[[nodiscard]] Surroundings surroundings_of(const PosedMesh& mesh, const Vec3& point, double reach);

/// A convex polytope around a point that no triangle enters, within the cube of half-edge `reach` around it: of the
/// triangles that are not cut off yet, the nearest to the point is, until none is left (after R. Deits, R. Tedrake,
/// "Computing large convex regions of obstacle-free space through semidefinite programming", 2014, with balls for their
/// ellipsoids). Rounded: whoever needs to know that it lies inside has to prove it. Empty where the point is too near
/// to a triangle.
[[nodiscard]] std::optional<ConvexHull> grow_convex(const Surroundings& around, CutBy cut);

}  // namespace toccata
