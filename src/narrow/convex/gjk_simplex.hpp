#pragma once

#include <array>
#include <cstddef>

#include "narrow/exact/vertex_pairs.hpp"
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

  /// Leaves the pairs whose bits are set.
  void keep(unsigned bits);
};

/// The face of a simplex whose relative interior contains its point nearest to the origin, as far as doubles tell.
struct NearestFace {
  Vec3 nearest;
  double squared = 0;  ///< nearest · nearest
  Vec3 direction;      ///< a positive multiple of `nearest`, known sooner
  unsigned kept = 0;   ///< the corners of the face, as bits; all four when the origin seems to be inside
};

/// The newest pair is taken to be needed.
[[nodiscard]] NearestFace nearest_face(const GjkSimplex& simplex);

}  // namespace toccata
