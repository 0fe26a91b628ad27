#pragma once

#include <memory>

#include "toccata/bounds/aabb.hpp"
#include "toccata/shapes/mesh_parts.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/tree.hpp"
#include "toccata/trees/wide_tree.hpp"

namespace toccata {

/// A shape made ready for questions: the shape, shared and immutable, and the trees over it. Copies share all. Build
/// one per shape and pose it as often as needed; questions from many threads may share one.
class Model {
 public:
  /// The tree is built on up to `threads` threads (0: as many as the machine has); it does not depend on them. Throws
  /// Error when the mesh has more triangles than a tree holds (2²⁸).
  explicit Model(TriangleMesh mesh, int threads = 1);
  explicit Model(std::shared_ptr<const TriangleMesh> mesh, int threads = 1);

  [[nodiscard]] const TriangleMesh& mesh() const;

  /// Over the triangles: the tree that questions use.
  [[nodiscard]] const WideTree& wide_tree() const;

  /// The plain binary tree over the triangles, for comparison; built when first asked for.
  [[nodiscard]] const Tree<Aabb>& tree() const;

  /// Around all vertices, also those that no triangle uses; in the mesh's own frame, exact.
  [[nodiscard]] const Aabb& vertex_box() const;

  /// The connected parts of the mesh; found out when first asked for.
  [[nodiscard]] const MeshParts& mesh_parts() const;

  /// Closed: may be taken as a solid. Found out when first asked for.
  [[nodiscard]] bool closed() const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

/// What a question takes the model for: `all` means solid, `none` surface, `automatic` solid when the mesh is closed.
[[nodiscard]] inline bool taken_as_solid(const Model& model, Solid solid) {
  return solid == Solid::all || (solid == Solid::automatic && model.closed());
}

}  // namespace toccata
