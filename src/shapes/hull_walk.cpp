#include "shapes/hull_walk.hpp"

#include "toccata/math/predicates.hpp"

namespace toccata {

Index highest_vertex(const ConvexHull& hull, const Vec3& a, const Vec3& b, const Vec3& c, Index start) {
  const HullTopology topology = hull.topology();
  if (topology.origin.empty()) return 0;
  Index vertex = start;
  Index half_edge = topology.leaving[vertex];
  const auto on_plane = [&](const Vec3& p) { return p == a || p == b || p == c; };
  const auto higher = [&](Index other) {
    // Both are often corners of the face whose plane it is.
    if (on_plane(hull.vertex(other)) && on_plane(hull.vertex(vertex))) return false;
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

std::vector<FaceVisit> faces_by_neighbours(const HullTopology& topology) {
  std::vector<FaceVisit> visits;
  if (topology.face_count() == 0) return visits;
  std::vector<bool> reached(topology.face_count(), false);
  visits.reserve(topology.face_count());
  visits.push_back({0, 0});
  reached[0] = true;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Index face = visits[i].face;
    for (Index h = topology.face_start[face]; h < topology.face_start[face + 1]; ++h) {
      const Index beyond = topology.face[topology.twin[h]];
      if (reached[beyond]) continue;
      reached[beyond] = true;
      visits.push_back({beyond, face});
    }
  }
  return visits;
}

}  // namespace toccata
