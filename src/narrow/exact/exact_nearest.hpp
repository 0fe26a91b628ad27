#pragma once

#include <span>

#include "math/homogeneous_vector.hpp"
#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// The nearest points of the hulls of two shapes' world vertices, their radii left aside. Lengths are in 2^exponent.
struct ExactNearest {
  bool meet = false;  ///< they have a point in common
  int exponent = 0;
  HomogeneousVector on_a;
  HomogeneousVector on_b;
  IntegerVector direction;          ///< a positive multiple of on_a − on_b
  WideInteger squared_numerator;    ///< the square of the distance is
  WideInteger squared_denominator;  ///< squared_numerator / squared_denominator
  VertexPairs simplex;              ///< whose hull contains on_a − on_b, all of them needed
};

/// Exact, for all finite coordinates. Where nearest points are not unique: the pair whose on_a is the least in
/// lexicographic order; where the hulls meet: a common point, which depends on `start`. `start` has at least one pair.
///
/// E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the distance between complex objects in
/// three-dimensional space", 1988, in integers. It ends: a vertex is added only when it lies before the plane through
/// the nearest point of the simplex, so that simplices stay affinely independent and each is nearer than the one
/// before; there are finitely many.
[[nodiscard]] ExactNearest exact_nearest(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& start);

/// The same where it is known already which vertices lie in the planes across the direction of nearest points:
/// `simplex` contains that direction's foot, `face_a` and `face_b` are all vertices in the two planes.
[[nodiscard]] ExactNearest exact_nearest_of_faces(const PosedPolytope& a, const PosedPolytope& b,
                                                  const VertexPairs& simplex, std::span<const Index> face_a,
                                                  std::span<const Index> face_b);

}  // namespace toccata
