#include "generate/mesh_building.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"

namespace toccata {

void add_face(PolygonMesh& mesh, const std::vector<Index>& corners) {
  mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
  mesh.first.push_back(static_cast<Index>(mesh.corners.size()));
}

void add_face(PolygonMesh& mesh, std::initializer_list<Index> corners) { add_face(mesh, std::vector<Index>(corners)); }

TriangleMesh tube_closed_on_itself(Rings rings) {
  PolygonMesh mesh;
  for (int k = 0; k < rings.count(); ++k)
    for (int i = 0; i < rings.per_ring; ++i)
      add_face(mesh, {rings.at(k, i), rings.at(k, i + 1), rings.at(k + 1, i + 1), rings.at(k + 1, i)});
  mesh.vertices = std::move(rings.points);
  return triangulate(mesh);
}

void require_range(const std::string& what, double value, double least, double greatest) {
  if (value >= least && value <= greatest) return;  // false for NaN
  throw Error(fmt::format("{} must be from {} to {}, and is {}", what, least, greatest, value));
}

Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double squared = dot(v, v);
    if (squared > 0.01 && squared <= 1) return plain_unit_or_zero(v);
  }
}

}  // namespace toccata
