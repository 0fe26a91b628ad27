#pragma once

#include "narrow/ray_triangle.hpp"
#include "query/posed_mesh.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata {

/// The first triangle that a ray meets: least by (upper end, number).
struct TriangleHit {
  RayTime time;
  Index triangle = 0;
};

/// A posed mesh that rays are cast at, and what is the same for all of them: a way back from the world into the units
/// of the mesh's tree, with a bound on what it is off by (docs/design/rays.md). The mesh must outlive it.
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
  Mat3 back_;               ///< about the inverse of the pose's matrix, in the tree's units
  Vec3 origin_;             ///< of the tree, in its units
  Aabb box_;                ///< of the tree, in its units
  double off_ = 0;          ///< what a point in the tree's units is off by: this, and
  double off_by_size_ = 0;  ///< that for each unit of length of the ray's coordinates in the world
  bool invertible_ = false;
};

}  // namespace toccata
