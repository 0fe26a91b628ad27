#pragma once

#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::test {

// Small closed meshes with known insides, and random pairs of them that touch, overlap and coincide often.

/// A closed box whose faces are cut along the other diagonals than those of box_between.
TriangleMesh other_box_mesh(const Vec3& lower, const Vec3& upper);

/// The prism over an L: the square [0, 2]² without (1, 2]², from z = 0 to 1.
TriangleMesh l_mesh();

TriangleMesh tetrahedron_mesh(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

/// A sphere-like mesh from an octahedron whose faces are cut into four `levels` times, around the origin; star-shaped.
TriangleMesh sphere_mesh(double radius, int levels);

/// Every triangle turned round.
TriangleMesh inverted(const TriangleMesh& mesh);

/// All as one mesh.
TriangleMesh joined(const std::vector<TriangleMesh>& meshes);

/// Scaled by a factor and moved, in the file's own coordinates.
TriangleMesh placed(const TriangleMesh& mesh, double factor, const Vec3& offset);

/// A pair of meshes and how they are asked about.
struct RelationCase {
  TriangleMesh a;
  TriangleMesh b;
  PairQuery query;
};

const std::vector<std::string>& relation_families();
RelationCase random_relation_case(const std::string& family, Random& random);

}  // namespace toccata::test
