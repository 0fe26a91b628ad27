#include "shapes/hull_walk.hpp"

#include "toccata/math/predicates.hpp"

namespace toccata {

Index highest_vertex(const ConvexHull& hull, const Vec3& a, const Vec3& b, const Vec3& c, Index start) {
  const HullTopology topology = hull.topology();
  if (topology.origin.empty()) return 0;
  Index vertex = start;
  Index half_edge = topology.leaving[vertex];
  const auto higher = [&](Index other) {
    return triple_product_sign({b, a}, {c, a}, {hull.vertex(other), hull.vertex(vertex)}) == Sign::positive;
  };
  // Goes round the vertex until it has seen all neighbours, or to the first that is higher.
  for (Index around = half_edge;;) {
    const Index neighbour = topology.target(around);
    if (higher(neighbour)) {
      vertex = neighbour;
      half_edge = around = topology.leaving[vertex];
      continue;
    }
    around = topology.next(topology.twin[around]);
    if (around == half_edge) return vertex;
  }
}

}  // namespace toccata
