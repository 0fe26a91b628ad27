#pragma once

#include <vector>

#include "world/character_mover/mover_body.hpp"

namespace toccata {

/// The unit normals of those faces of a convex polytope that have a point, within a tolerance, turned as `outward` is;
/// none of other sets, which have no edges or are round.
[[nodiscard]] std::vector<Vec3> face_normals_at(const LevelSet& set, const Vec3& point, const Vec3& outward,
                                                double tolerance);

}  // namespace toccata
