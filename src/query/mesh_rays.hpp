#pragma once

#include "narrow/ray_triangle.hpp"
#include "query/way_into_tree.hpp"

namespace toccata {

/// The first triangle that a ray meets: least by (upper end, number).
struct TriangleHit {
  RayTime time;
  Index triangle = 0;
};

/// A posed mesh that rays are cast at, and what is the same for all of them (docs/design/rays.md). The mesh must
/// outlive it.
class RayTarget {
 public:
  explicit RayTarget(const PosedMesh& mesh);

  /// Of a ray at the surface. That there is none is proved.
  [[nodiscard]] TriangleHit first_hit(const PreparedRay& ray) const;

  [[nodiscard]] Triangle world_triangle(Index number) const;

 private:
  [[nodiscard]] TriangleHit search_in_tree(const PreparedRay& ray, const Vec3& origin, const Vec3& motion,
                                           double off) const;
  [[nodiscard]] TriangleHit search_in_world(const PreparedRay& ray) const;

  const PosedMesh& posed_;
  const TriangleMesh& mesh_;
  const WideTree& tree_;
  WayIntoTree way_;
  Aabb box_;  ///< of the tree, in its units
};

}  // namespace toccata
