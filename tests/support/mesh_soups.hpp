#pragma once

#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::test {

/// Small meshes and poses for comparing the queries with brute force.

/// Triangles of about `size` within the unit cube, some sharing vertices, some without area; coordinates are multiples
/// of 1/`grid` where grid is not 0, so that many of them touch.
TriangleMesh random_soup(Random& random, Index triangles, double size, double grid);

/// A closed axis-parallel box, normals outward.
TriangleMesh box_between(const Vec3& lower, const Vec3& upper);

/// rigid, scaled, sheared, mirrored, singular, far (offsets of 1e6), small (scale 1e-6), large (scale 1e6), snapped
/// (entries that are multiples of 1/2: many exact contacts).
const std::vector<std::string>& pose_families();

/// Two poses of a family, both general, such that two meshes in the unit cube lie near each other.
PairQuery random_poses(const std::string& family, Random& random);

/// Its coordinates are at most `size`, either way.
Vec3 random_vector(Random& random, double size);

/// A rotation by a random unit quaternion, up to rounding.
Mat3 random_rotation(Random& random);

}  // namespace toccata::test
