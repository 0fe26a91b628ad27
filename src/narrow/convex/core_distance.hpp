#pragma once

#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// How the distance of two cores, the hulls of the world vertices without the radii, compares with a length.
struct CoreDistanceOrder {
  Sign sign = Sign::zero;  ///< of distance − length
  bool by_exact = false;   ///< exact arithmetic was needed
  VertexPairs simplex;     ///< where the search ended
};

/// Compares the distance of the cores with the length x + y, which is not negative; exactly. Searches from `start`,
/// which may be empty.
[[nodiscard]] CoreDistanceOrder compare_core_distance(const PosedPolytope& a, const PosedPolytope& b, double x,
                                                      double y, const VertexPairs& start);

/// The same, without a search where `simplex` proves it: mostly one has ended there. It may be empty, or of other
/// shapes.
[[nodiscard]] CoreDistanceOrder compare_core_distance_at(const PosedPolytope& a, const PosedPolytope& b, double x,
                                                         double y, const VertexPairs& simplex);

/// Some point of the simplex is nearer to the origin than the length: proved in doubles.
[[nodiscard]] bool certainly_nearer(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex,
                                    double length);

}  // namespace toccata
