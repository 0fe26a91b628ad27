#include "toccata/query/model.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "query/manifolds/vertex_fans.hpp"
#include "query/nearest/way_into_tree.hpp"
#include "toccata/core/error.hpp"
#include "toccata/shapes/mesh_health.hpp"
#include "toccata/trees/builders.hpp"
#include "trees/box_runs.hpp"
#include "trees/leaf_triangles.hpp"
#include "trees/oriented_boxes.hpp"
#include "trees/wide_check.hpp"
#include "trees/winding_moments.hpp"

namespace toccata {
namespace {

std::vector<Aabb> boxes_of(const TriangleMesh& mesh) {
  std::vector<Aabb> boxes;
  boxes.reserve(mesh.triangle_count());
  for (std::size_t triangle = 0; triangle < mesh.triangle_count(); ++triangle)
    boxes.push_back(triangle_box(mesh, triangle));
  return boxes;
}

std::shared_ptr<const TriangleMesh> require_mesh(std::shared_ptr<const TriangleMesh> mesh) {
  if (!mesh) throw Error("a model needs a mesh, and the pointer given is null");
  return mesh;
}

WideBvh require_tree(WideBvh tree, const TriangleMesh& mesh) {
  if (const std::string fault = fault_of(tree, mesh); !fault.empty())
    throw Error(fmt::format("this is no tree over the mesh of {} triangles: {}; build one from the mesh",
                            mesh.triangle_count(), fault));
  return tree;
}

}  // namespace

struct Model::Parts {
  Parts(Shape given, std::shared_ptr<const TriangleMesh> given_mesh, WideBvh given_tree)
      : shape(std::move(given)),
        mesh(std::move(given_mesh)),
        wide_bvh(std::move(given_tree)),
        vertex_box(fit_aabb(mesh->vertices())) {}

  Parts(Shape given, const std::shared_ptr<const TriangleMesh>& given_mesh, int threads)
      : Parts(std::move(given), given_mesh, build_wide_bvh(*given_mesh, {.threads = threads})) {}

  Parts(Compound given, int threads) : shape(given) {
    for (const CompoundPart& part : given.parts()) models.push_back(Model(part.shape, threads));
  }

  [[nodiscard]] bool has(ModelPart part) const {
    return is_made[static_cast<std::size_t>(part)].load(std::memory_order_acquire);
  }
  void tell_made(ModelPart part) const {
    is_made[static_cast<std::size_t>(part)].store(true, std::memory_order_release);
  }

  Shape shape;
  std::shared_ptr<const TriangleMesh> mesh;  ///< not of a compound
  WideBvh wide_bvh;
  Aabb vertex_box;
  std::vector<Model> models;  ///< of a compound

  // What not every question needs, made by the first that does.
  mutable std::once_flag tree_made, oriented_made, moments_made, leaves_made, parts_found, closed_known, fans_made;
  mutable Bvh<Aabb> tree;
  mutable std::vector<OrientedBlock> oriented_boxes;
  mutable std::vector<WindingMoments> winding_moments;
  mutable LeafTriangles leaf_triangles;
  mutable std::atomic<std::size_t> questions_at_leaves = 0;
  mutable MeshParts mesh_parts;
  mutable VertexFans vertex_fans;
  mutable bool closed = false;
  mutable std::array<std::atomic<bool>, all_model_parts.size()> is_made{};
};

Model::Model(TriangleMesh mesh, int threads) : Model(std::make_shared<const TriangleMesh>(std::move(mesh)), threads) {}

Model::Model(std::shared_ptr<const TriangleMesh> mesh, int threads)
    : parts_(std::make_shared<Parts>(Shape(mesh), require_mesh(mesh), threads)) {}

Model::Model(std::shared_ptr<const TriangleMesh> mesh, WideBvh tree)
    : parts_(std::make_shared<Parts>(Shape(mesh), mesh, require_tree(std::move(tree), *require_mesh(mesh)))) {}

Model::Model(HeightField field, int threads) : parts_(std::make_shared<Parts>(Shape(field), field.mesh(), threads)) {}

Model::Model(Compound compound, int threads) : parts_(std::make_shared<Parts>(std::move(compound), threads)) {}

Model Model::of_any(const Shape& shape, int threads) {
  return std::visit(
      [threads](const auto& given) {
        if constexpr (PlainShape<std::remove_cvref_t<decltype(given)>>)
          return Model(given);
        else
          return Model(given, threads);
      },
      shape);
}

Refit Model::deform(std::vector<Vec3> vertices, int threads) {
  if (!std::holds_alternative<std::shared_ptr<const TriangleMesh>>(shape()))
    throw Error(fmt::format("a mesh can be deformed, and the model is a {}", name_of(shape())));
  const auto moved = std::make_shared<const TriangleMesh>(mesh().with_vertices(std::move(vertices)));
  const auto next = std::make_shared<Parts>(Shape(moved), moved, WideBvh{});
  const bool alone = parts_.use_count() == 1;
  if (!alone) next->wide_bvh = parts_->wide_bvh;
  const Refit done = refit(alone ? parts_->wide_bvh : next->wide_bvh, *next->mesh, threads);
  if (alone) next->wide_bvh = std::move(parts_->wide_bvh);
  parts_ = next;
  if (done.should_rebuild()) parts_->wide_bvh = build_wide_bvh(mesh(), {.threads = threads});
  return done;
}

const Shape& Model::shape() const { return parts_ ? parts_->shape : plain_; }

bool Model::has_mesh() const { return parts_ && parts_->mesh; }

std::span<const Model> Model::parts() const {
  return parts_ ? std::span<const Model>(parts_->models) : std::span<const Model>();
}

Index Model::element_count() const {
  if (has_mesh()) return mesh().triangle_count();
  Index count = parts().empty() ? 1 : 0;
  for (const Model& part : parts()) count += part.element_count();
  return count;
}

Index Model::face_count() const {
  if (has_mesh()) return mesh().face_count();
  Index count = parts().empty() ? 1 : 0;
  for (const Model& part : parts()) count += part.face_count();
  return count;
}

const TriangleMesh& Model::mesh() const {
  if (!has_mesh()) throw Error(fmt::format("this is asked of a mesh, and the model is a {}", name_of(shape())));
  return *parts_->mesh;
}

const WideBvh& Model::wide_bvh() const {
  static_cast<void>(mesh());
  return parts_->wide_bvh;
}

const Aabb& Model::bounds() const {
  static_cast<void>(mesh());
  return parts_->vertex_box;
}

const Bvh<Aabb>& Model::tree() const {
  const TriangleMesh& triangles = mesh();
  std::call_once(parts_->tree_made, [&] { parts_->tree = build_bvh(boxes_of(triangles)); });
  return parts_->tree;
}

std::span<const OrientedBlock> Model::oriented_boxes() const {
  const TriangleMesh& triangles = mesh();
  std::call_once(parts_->oriented_made, [&] {
    parts_->oriented_boxes = toccata::oriented_boxes(parts_->wide_bvh, triangles);
    parts_->tell_made(ModelPart::turned_boxes);
  });
  return parts_->oriented_boxes;
}

std::span<const WindingMoments> Model::winding_moments() const {
  const TriangleMesh& triangles = mesh();
  std::call_once(parts_->moments_made, [&] {
    parts_->winding_moments = toccata::winding_moments(parts_->wide_bvh, triangles);
    parts_->tell_made(ModelPart::winding);
  });
  return parts_->winding_moments;
}

const LeafTriangles& Model::leaf_triangles() const {
  const TriangleMesh& triangles = mesh();
  std::call_once(parts_->leaves_made, [&] {
    const WideBvh& wide = parts_->wide_bvh;
    parts_->leaf_triangles = toccata::leaf_triangles(wide, triangles);
    parts_->leaf_triangles.at_identity = ray_frame(wide, WayIntoTree(wide), {});
    parts_->tell_made(ModelPart::leaf_triangles);
  });
  return parts_->leaf_triangles;
}

const LeafTriangles* Model::leaf_triangles_for(std::size_t questions) const {
  // Making them takes as long per triangle as they save in about a tenth of a question.
  constexpr std::size_t triangles_per_question = 16;
  if (parts_ && parts_->has(ModelPart::leaf_triangles)) return &parts_->leaf_triangles;
  const std::size_t triangles = mesh().triangle_count();
  const std::size_t asked = parts_->questions_at_leaves.fetch_add(questions, std::memory_order_relaxed) + questions;
  return asked >= triangles / triangles_per_question ? &leaf_triangles() : nullptr;
}

const MeshParts& Model::mesh_parts() const {
  const TriangleMesh& triangles = mesh();
  std::call_once(parts_->parts_found, [&] { parts_->mesh_parts = toccata::mesh_parts(triangles); });
  return parts_->mesh_parts;
}

bool Model::closed() const {
  const TriangleMesh& triangles = mesh();
  std::call_once(parts_->closed_known, [&] {
    parts_->closed = is_closed(triangles);
    parts_->tell_made(ModelPart::solidity);
  });
  return parts_->closed;
}

const VertexFans& Model::vertex_fans() const {
  static_cast<void>(mesh());
  std::call_once(parts_->fans_made, [&] {
    parts_->vertex_fans = VertexFans(*this);
    parts_->tell_made(ModelPart::neighbours);
  });
  return parts_->vertex_fans;
}

namespace {

/// What a part of a model takes: measured of a mesh of a million triangles, where building the tree is 1.
struct PartMeasure {
  double bytes_per_triangle;
  double of_building;
};

constexpr PartMeasure measure_of(ModelPart part) {
  switch (part) {
    case ModelPart::solidity:
      return {0, 0.2};
    case ModelPart::leaf_triangles:
      return {53, 0.2};
    case ModelPart::turned_boxes:
      return {75, 1.7};
    case ModelPart::winding:
      return {80, 0.6};
    case ModelPart::neighbours:
      return {26, 0.7};
  }
  return {};
}

void make_part(const Model& mesh, ModelPart part) {
  switch (part) {
    case ModelPart::solidity:
      static_cast<void>(mesh.closed());
      return;
    case ModelPart::leaf_triangles:
      static_cast<void>(mesh.leaf_triangles());
      return;
    case ModelPart::turned_boxes:
      static_cast<void>(mesh.oriented_boxes());
      return;
    case ModelPart::winding:
      static_cast<void>(mesh.winding_moments());
      return;
    case ModelPart::neighbours:
      static_cast<void>(mesh.vertex_fans());
      return;
  }
}

/// Itself, or its parts and theirs.
void visit_meshes(const Model& model, const FunctionRef<void(const Model&)>& see) {
  if (model.has_mesh()) see(model);
  for (const Model& part : model.parts()) visit_meshes(part, see);
}

}  // namespace

void Model::prepare(std::span<const ModelPart> wanted, int threads) const {
  struct Work {
    const Model* mesh;
    ModelPart part;
  };
  std::vector<Work> work;
  visit_meshes(*this, [&](const Model& mesh) {
    for (const ModelPart part : wanted)
      if (!mesh.parts_->has(part)) work.push_back({&mesh, part});
  });
  parallel_for(work.size(), threads, [&](std::size_t i) { make_part(*work[i].mesh, work[i].part); });
}

std::vector<PartCost> Model::part_costs() const {
  std::vector<PartCost> costs;
  visit_meshes(*this, [&](const Model& mesh) {
    if (costs.empty())
      for (const ModelPart part : all_model_parts) costs.push_back({part, true, 0, measure_of(part).of_building});
    for (PartCost& cost : costs) {
      cost.is_made = cost.is_made && mesh.parts_->has(cost.part);
      cost.bytes += static_cast<std::size_t>(measure_of(cost.part).bytes_per_triangle * mesh.element_count());
    }
  });
  return costs;
}

namespace {

struct TakenAsSolid {
  bool operator()(const Point&) const { return false; }
  bool operator()(const Segment&) const { return false; }
  bool operator()(const Triangle&) const { return false; }
  bool operator()(const HeightField&) const { return false; }
  bool operator()(const ConvexHull& hull) const { return hull.dimension() == 3; }
  bool operator()(const std::shared_ptr<const TriangleMesh>&) const {
    return solid == Solid::all || (solid == Solid::automatic && model.closed());
  }
  bool operator()(const Compound&) const {
    const auto parts = model.parts();
    return std::all_of(parts.begin(), parts.end(), [&](const Model& part) { return taken_as_solid(part, solid); });
  }
  template <class Other>
  bool operator()(const Other&) const {
    return true;
  }

  const Model& model;
  Solid solid;
};

}  // namespace

bool taken_as_solid(const Model& model, Solid solid) { return std::visit(TakenAsSolid{model, solid}, model.shape()); }

}  // namespace toccata
