#pragma once

#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::test {

/// A small mesh that may meet itself, and where it is.
struct SelfMesh {
  TriangleMesh mesh;
  Pose pose;
};

/// grid (triangles of few points, many without area), sheets (a folded, noisy sheet), strips (folded flat onto
/// themselves), needles (around a hub), duplicates, soups (random, under all kinds of poses), tiny (about 1e-300), huge
/// (about 1e300), far (1e15 from the origin, where vertices collapse). Half of all have three vertices of its own for
/// every triangle.
const std::vector<std::string>& self_mesh_families();

SelfMesh random_self_mesh(const std::string& family, Random& random);

/// The same triangles, each with vertices of its own.
TriangleMesh unwelded(const TriangleMesh& mesh);

}  // namespace toccata::test
