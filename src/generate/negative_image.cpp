#include <algorithm>
#include <utility>

#include "generate/mesh_building.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

Aabb box_around(const TriangleMesh& mesh) {
  Aabb box{mesh.vertices()[0], mesh.vertices()[0]};
  for (const Vec3& p : mesh.vertices())
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], p[axis]);
      box.upper[axis] = std::max(box.upper[axis], p[axis]);
    }
  return box;
}

}  // namespace

TriangleMesh negative_image(const TriangleMesh& mesh, double margin) {
  require_range("the margin", margin, 1e-300, 1e300);
  const Aabb box = box_around(mesh);
  const Vec3 half = 0.5 * (box.upper - box.lower) + Vec3{margin, margin, margin};
  const TriangleMesh outside = box_mesh(half, box.lower + 0.5 * (box.upper - box.lower));
  std::vector<Vec3> vertices(outside.vertices().begin(), outside.vertices().end());
  std::vector<std::array<Index, 3>> triangles(outside.triangles().begin(), outside.triangles().end());
  std::vector<Index> faces;
  for (Index t = 0; t < outside.triangle_count(); ++t) faces.push_back(outside.face_of(t));
  const Index first = static_cast<Index>(vertices.size());
  vertices.insert(vertices.end(), mesh.vertices().begin(), mesh.vertices().end());
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto& [a, b, c] = mesh.triangles()[t];
    triangles.push_back({first + a, first + c, first + b});
    faces.push_back(outside.face_count() + mesh.face_of(t));
  }
  return {std::move(vertices), std::move(triangles), std::move(faces)};
}

TriangleMesh scaled_mesh(const TriangleMesh& mesh, double factor) {
  std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec3& v : vertices) v = factor * v;
  std::vector<Index> faces;
  for (Index t = 0; t < mesh.triangle_count(); ++t) faces.push_back(mesh.face_of(t));
  return {std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()}, std::move(faces)};
}

}  // namespace toccata
