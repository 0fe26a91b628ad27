#pragma once

#include <span>
#include <vector>

#include "methods/cost/cost_walk.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

// The library's own trees and questions, for comparison with the plain ones.

/// Where the vertices of both meshes are.
struct MovedVertices {
  std::span<const Vec3> a;
  std::span<const Vec3> b;
};

/// One query with the whole of its time put on the tests of boxes.
[[nodiscard]] QueryCost cost_of_library(const Model& a, const Model& b, const PairQuery& query, CostTask task);

/// Builds everything that the question needs anew; `update` is that.
[[nodiscard]] QueryCost cost_of_library_anew(const TriangleMesh& a, const TriangleMesh& b, const MovedVertices& moved,
                                             CostTask task);

/// Deforms both models, which are left as they are, to other vertices; `update` is that.
[[nodiscard]] QueryCost cost_of_library_deformed(const Model& a, const Model& b, const MovedVertices& moved,
                                                 CostTask task);

struct LibraryBvh {
  std::size_t boxes = 0;
  std::size_t bytes = 0;
  int greatest_depth = 0;
  double build_ns = 0;
};
[[nodiscard]] LibraryBvh library_bvh(const TriangleMesh& mesh, CostTask task);

}  // namespace toccata
