#pragma once

#include <cstddef>
#include <vector>

#include "query/penetration/solid_body.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {

/// Two solids, the second moved.
struct MovedPair {
  const SolidBody& a;
  const SolidBody& b;
  Vec3 move;  ///< of B
};

/// A point of the world from where convex bodies within two solids are grown.
struct SeparatingSeed {
  Vec3 point;
  double depth;  ///< about how far from where the surfaces were looked at
};

/// A point at which the surfaces meet, and the normals of the triangles there.
struct SurfaceIntersection {
  Vec3 point;
  Vec3 normal_a;
  Vec3 normal_b;
};

/// Up to `most` points inside both solids, far from each other and rather deep, the deepest first; B is moved as told.
/// They are looked for on both sides of some points at which the surfaces meet, and below both surfaces.
[[nodiscard]] std::vector<SeparatingSeed> find_seeds(const MovedPair& pair,
                                                     const std::vector<SurfaceIntersection>& intersections,
                                                     std::size_t most);

}  // namespace toccata
