#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {

/// What convex bodies say of a solid mesh at its place.
struct WholeBody {
  ConvexHull hull;                  ///< of the vertices of its triangles
  bool is_convex = false;           ///< the hull is the solid
  std::optional<ConvexHull> drawn;  ///< else all but a share of 2^-40 of the hull, where that lies within the solid
};

/// Looks at all vertices and triangles.
[[nodiscard]] WholeBody whole_body_of(const PosedMesh& mesh);

/// The bodies of the meshes that were asked about last, so that an object of many pairs is looked at once and not at
/// each of them. A body depends on nothing but the mesh and its pose: what is kept here changes no answer.
class WholeBodies {
 public:
  [[nodiscard]] std::shared_ptr<const WholeBody> of(const PosedMesh& mesh);

 private:
  struct Kept {
    std::weak_ptr<const TriangleMesh> mesh;  // not held: who drops it has its memory back
    Pose pose;
    std::shared_ptr<const WholeBody> body;
  };

  std::deque<Kept> kept_;  // what was asked about last comes first
  std::size_t vertices_ = 0;
};

}  // namespace toccata
