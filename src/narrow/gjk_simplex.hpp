#pragma once

#include <array>
#include <cstddef>

#include "narrow/vertex_pairs.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// A simplex of the Minkowski difference in doubles, the newest pair last.
struct GjkSimplex {
  VertexPairs pairs;
  std::array<Vec3, 4> point{};  ///< a − b, rounded

  void append(Index a, Index b, const Vec3& difference) {
    point[pairs.size] = difference;
    pairs.append(a, b);
  }
};

/// Leaves of the simplex the face whose relative interior contains its point nearest to the origin, as far as doubles
/// tell, and returns that point. All four pairs stay when the origin seems to be inside. The newest pair is taken to be
/// needed.
Vec3 reduce(GjkSimplex& simplex);

}  // namespace toccata
