#include "toccata/query/model.hpp"

#include <utility>
#include <vector>

#include "query/posed_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/shapes/mesh_health.hpp"
#include "toccata/trees/build.hpp"

namespace toccata {
namespace {

Tree<Aabb> tree_over(const TriangleMesh& mesh) {
  std::vector<Aabb> boxes;
  boxes.reserve(mesh.triangle_count());
  const auto vertices = mesh.vertices();
  for (const auto& corner : mesh.triangles())
    boxes.push_back(box_of({{vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}}));
  return build_tree(boxes);
}

std::vector<Index> unused_vertices_of(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.vertices().size());
  for (const auto& corners : mesh.triangles())
    for (const Index corner : corners) used[corner] = true;
  std::vector<Index> unused;
  for (Index i = 0; i < used.size(); ++i)
    if (!used[i]) unused.push_back(i);
  return unused;
}

std::shared_ptr<const TriangleMesh> require_mesh(std::shared_ptr<const TriangleMesh> mesh) {
  if (!mesh) throw Error("a model needs a mesh, and the pointer given is null");
  return mesh;
}

}  // namespace

Model::Model(TriangleMesh mesh) : Model(std::make_shared<const TriangleMesh>(std::move(mesh))) {}

Model::Model(std::shared_ptr<const TriangleMesh> mesh)
    : mesh_(require_mesh(std::move(mesh))),
      tree_(std::make_shared<const Tree<Aabb>>(tree_over(*mesh_))),
      unused_vertices_(std::make_shared<const std::vector<Index>>(unused_vertices_of(*mesh_))),
      closed_(is_closed(*mesh_)) {}

}  // namespace toccata
