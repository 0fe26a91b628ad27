#include "query/relation/hull_mesh.hpp"

#include <array>
#include <utility>
#include <vector>

namespace toccata {
namespace {

using CornerTriples = std::vector<std::array<Index, 3>>;

/// All vertices of a face are extreme and exactly coplanar, so a fan covers it.
void add_fan(const HullTopology& topology, Index face, CornerTriples& triangles) {
  const Index first = topology.face_start[face], end = topology.face_start[face + 1];
  for (Index h = first + 1; h + 1 < end; ++h)
    triangles.push_back({topology.origin[first], topology.origin[h], topology.origin[h + 1]});
}

CornerTriples triangles_of(const ConvexHull& hull) {
  if (hull.dimension() == 0) return {{0, 0, 0}};
  if (hull.dimension() == 1) return {{0, 1, 1}};
  const HullTopology topology = hull.topology();
  const Index faces = hull.dimension() == 2 ? 1 : topology.face_count();  // of a flat one the front alone
  CornerTriples triangles;
  for (Index face = 0; face < faces; ++face) add_fan(topology, face, triangles);
  return triangles;
}

}  // namespace

HullMesh hull_mesh(const PosedPolytope& shape) {
  std::vector<Vec3> points;
  points.reserve(shape.vertex_count());
  for (Index i = 0; i < shape.vertex_count(); ++i) points.push_back(shape.vertex(i));
  const ConvexHull hull(points);
  std::vector<Vec3> vertices;
  vertices.reserve(hull.vertex_count());
  for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(hull.vertex(i));
  return {std::make_shared<const TriangleMesh>(std::move(vertices), triangles_of(hull)), hull.dimension()};
}

}  // namespace toccata
