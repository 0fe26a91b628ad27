#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "toccata/core/random.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

void add_face(PolygonMesh& mesh, std::initializer_list<Index> corners);
void add_face(PolygonMesh& mesh, const std::vector<Index>& corners);

/// Rings of equally many points, one after the other along a tube. Each turns counter-clockwise for someone who looks
/// back at it from the next.
struct Rings {
  std::vector<Vec3> points;
  int per_ring = 0;

  [[nodiscard]] int count() const { return static_cast<int>(points.size()) / per_ring; }
  /// Point i of ring k, both taken around.
  [[nodiscard]] Index at(int k, int i) const { return static_cast<Index>((k % count()) * per_ring + (i % per_ring)); }
};

/// A tube whose last ring is followed by the first, of quadrilaterals.
[[nodiscard]] TriangleMesh tube_closed_on_itself(Rings rings);

/// Throws Error("<message>; here it is …") unless least ≤ value ≤ greatest.
void require_range(const std::string& what, double value, double least, double greatest);

/// Uniform on the unit sphere.
[[nodiscard]] Vec3 random_direction(Random& random);

}  // namespace toccata
