#pragma once

#include <optional>
#include <span>

#include "narrow/triangles/ray_triangle.hpp"
#include "query/meshes/posed_mesh.hpp"
#include "query/nearest/way_into_tree.hpp"
#include "trees/rays_into_tree.hpp"

namespace toccata {

/// The first triangle that a ray meets: least by (upper end, number).
struct TriangleHit {
  RayTime time;  ///< of this triangle
  Index triangle = 0;
  double lower = 0;            ///< of all triangles: the exact first time lies in [lower, time.upper]
  std::optional<Cast> cast{};  ///< ray_hit of it, where that is known already
};

/// A posed mesh that rays are cast at, and what is the same for all of them
/// (docs/design/rays.md). The mesh must outlive it.
class RayTarget {
 public:
  explicit RayTarget(const PosedMesh& mesh);

  /// A mesh at the identity, which is not posed where it need not be, and its
  /// leaves or null. The model must outlive it.
  RayTarget(const Model& standing, const LeafTriangles* leaves);

  /// The first hit of a ray at the surface. That there is none is proved.
  [[nodiscard]] TriangleHit first_hit(const PreparedRay& ray) const;
  /// The same of many, which are walked side by side.
  void first_hits(std::span<const PreparedRay> rays, std::span<TriangleHit> hits) const;

  [[nodiscard]] Triangle world_triangle(Index number) const;
  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

 private:
  /// So many rays are searched for with the memory of one search, which stays
  /// near.
  static constexpr std::size_t together = 256;
  void search_together(std::span<const PreparedRay> rays, std::span<TriangleHit> hits) const;
  struct Together;
  void take_passing(Together& all, std::span<TriangleHit> hits) const;
  /// Tells the search of a triangle that may be met.
  template <class Search>
  void consider(const RayCandidate& candidate, Search& search) const;
  [[nodiscard]] TriangleHit search_in_world(const PreparedRay& ray) const;

  [[nodiscard]] const RayFrame& frame() const { return own_frame_ ? *own_frame_ : leaves_->at_identity; }
  [[nodiscard]] const LeafTriangles* leaves_for(std::size_t rays) const {
    return posed_ == nullptr ? leaves_ : model_.leaf_triangles_for(rays);
  }

  const Model& model_;
  const PosedMesh* posed_;  ///< none at the identity
  const TriangleMesh& mesh_;
  const WideBvh& tree_;
  const LeafTriangles* leaves_;  ///< at the identity, or null
  /// Where it is not that of the leaves. What is not usable makes the world be
  /// searched.
  std::optional<RayFrame> own_frame_;
  bool stands_;  ///< the pose changes nothing but the sign of a zero
};

}  // namespace toccata
