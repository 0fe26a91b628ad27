#pragma once

#include <vector>

#include "math/homogeneous_vector.hpp"

namespace toccata {

/// The vertices of two flat convex sets in parallel planes (a set may be a segment or a point), of which the second
/// moved by `difference` lies in the plane of the first and meets it.
struct ParallelFaces {
  std::vector<IntegerVector> a;
  std::vector<IntegerVector> b;
  IntegerVector normal;          ///< of both planes
  HomogeneousVector difference;  ///< along the normal
};

/// The least point, in lexicographic order, of A that is also in B + difference.
[[nodiscard]] HomogeneousVector least_meeting_point(const ParallelFaces& faces);

}  // namespace toccata
