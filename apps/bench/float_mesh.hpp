#pragma once

#include "toccata/core/random.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

// Questions about one mesh whose numbers floats hold, which is what some peers take.
namespace toccata::bench {

[[nodiscard]] Vec3 as_floats(const Vec3& v);

/// The mesh with coordinates that floats hold.
[[nodiscard]] TriangleMesh of_floats(const TriangleMesh& mesh);

/// A vector of length 1, as likely in one direction as in any other.
[[nodiscard]] Vec3 random_direction(Random& random);

}  // namespace toccata::bench
