#pragma once

#include <memory>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/tree.hpp"

namespace toccata {

/// A shape made ready for questions: the shape, shared and immutable, and the tree over it. Copies share both. Build
/// one per shape and pose it as often as needed; questions from many threads may share one.
class Model {
 public:
  explicit Model(TriangleMesh mesh);
  explicit Model(std::shared_ptr<const TriangleMesh> mesh);

  [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }
  [[nodiscard]] const Tree<Aabb>& tree() const { return *tree_; }

  /// The vertices that no triangle uses, ascending: they are no part of the shape.
  [[nodiscard]] std::span<const Index> unused_vertices() const { return *unused_vertices_; }

  /// Closed: may be taken as a solid.
  [[nodiscard]] bool closed() const { return closed_; }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::shared_ptr<const Tree<Aabb>> tree_;
  std::shared_ptr<const std::vector<Index>> unused_vertices_;
  bool closed_ = false;
};

/// What a question takes the model for: `all` means solid, `none` surface, `automatic` solid when the mesh is closed.
[[nodiscard]] inline bool taken_as_solid(const Model& model, Solid solid) {
  return solid == Solid::all || (solid == Solid::automatic && model.closed());
}

}  // namespace toccata
