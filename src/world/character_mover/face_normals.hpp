#pragma once

#include <vector>

#include "world/character_mover/thing_planes.hpp"

namespace toccata {

/// The normal of a face, of length 1 and out of the polytope; zero where its corners are rounded to a line.
[[nodiscard]] Vec3 normal_of_face(const PosedPolytope& polytope, Index face);

/// The unit normals of those faces of a convex polytope that have a point, within a tolerance, turned as `outward` is;
/// none of other sets, which have no edges or are round.
[[nodiscard]] std::vector<Vec3> face_normals_at(const LevelSet& set, const Vec3& point, const Vec3& outward,
                                                double tolerance);

}  // namespace toccata
