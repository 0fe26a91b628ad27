#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "math/wide_integer.hpp"
#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// Some vertices of a Minkowski difference in integers over 2^exponent.
struct IntegerSimplex {
  VertexPairs pairs;
  std::array<IntegerVector, 4> a;
  std::array<IntegerVector, 4> point;  ///< of the difference
  std::array<Vec3, 4> rounded_point;   ///< the same in doubles, not scaled
  int exponent = 0;
};

[[nodiscard]] IntegerSimplex integer_simplex(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& pairs);

/// Over a given exponent, for which all coordinates are whole.
[[nodiscard]] IntegerSimplex integer_simplex(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& pairs,
                                             int exponent);

/// The point nearest to the origin in the affine hull of a simplex: Σ weight · point / total, with total > 0.
struct SimplexNearest {
  std::array<WideInteger, 4> weight;
  WideInteger total;
  IntegerVector direction;  ///< a positive multiple of that point; zero when it is the origin
};

/// The simplex's points are affinely independent.
[[nodiscard]] SimplexNearest nearest_of(const IntegerSimplex& simplex);

/// The face of the simplex, with the last pair among its own, whose relative interior contains the point of the whole
/// simplex that is nearest to the origin; the last pair is known to be needed.
[[nodiscard]] VertexPairs needed_pairs(const IntegerSimplex& simplex);

}  // namespace toccata
