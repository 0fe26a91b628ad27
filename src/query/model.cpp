#include "toccata/query/model.hpp"

#include <mutex>
#include <utility>
#include <vector>

#include "query/posed_mesh.hpp"
#include "toccata/core/error.hpp"
#include "toccata/shapes/mesh_health.hpp"
#include "toccata/trees/build.hpp"

namespace toccata {
namespace {

std::vector<Aabb> boxes_of(const TriangleMesh& mesh) {
  std::vector<Aabb> boxes;
  boxes.reserve(mesh.triangle_count());
  const auto vertices = mesh.vertices();
  for (const auto& corner : mesh.triangles())
    boxes.push_back(box_of({{vertices[corner[0]], vertices[corner[1]], vertices[corner[2]]}}));
  return boxes;
}

std::shared_ptr<const TriangleMesh> require_mesh(std::shared_ptr<const TriangleMesh> mesh) {
  if (!mesh) throw Error("a model needs a mesh, and the pointer given is null");
  return mesh;
}

}  // namespace

struct Model::Parts {
  Parts(std::shared_ptr<const TriangleMesh> given, int threads)
      : mesh(std::move(given)),
        wide_tree(build_wide_tree(boxes_of(*mesh), {.threads = threads})),
        vertex_box(fit_aabb(mesh->vertices())) {}

  std::shared_ptr<const TriangleMesh> mesh;
  WideTree wide_tree;
  Aabb vertex_box;

  // What not every question needs, made by the first that does.
  mutable std::once_flag tree_made, parts_found, closed_known;
  mutable Tree<Aabb> tree;
  mutable MeshParts mesh_parts;
  mutable bool closed = false;
};

Model::Model(TriangleMesh mesh, int threads) : Model(std::make_shared<const TriangleMesh>(std::move(mesh)), threads) {}

Model::Model(std::shared_ptr<const TriangleMesh> mesh, int threads)
    : parts_(std::make_shared<const Parts>(require_mesh(std::move(mesh)), threads)) {}

const TriangleMesh& Model::mesh() const { return *parts_->mesh; }

const WideTree& Model::wide_tree() const { return parts_->wide_tree; }

const Aabb& Model::vertex_box() const { return parts_->vertex_box; }

const Tree<Aabb>& Model::tree() const {
  std::call_once(parts_->tree_made, [this] { parts_->tree = build_tree(boxes_of(mesh())); });
  return parts_->tree;
}

const MeshParts& Model::mesh_parts() const {
  std::call_once(parts_->parts_found, [this] { parts_->mesh_parts = toccata::mesh_parts(mesh()); });
  return parts_->mesh_parts;
}

bool Model::closed() const {
  std::call_once(parts_->closed_known, [this] { parts_->closed = is_closed(mesh()); });
  return parts_->closed;
}

}  // namespace toccata
