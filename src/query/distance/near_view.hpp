#pragma once

#include "query/meshes/posed_mesh.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "trees/near_walk.hpp"

namespace toccata {

/// Where the boxes of a tree are in the world: q, in the tree's units, at offset + linear · unit · q.
struct NearFrame {
  Mat3 linear;
  Vec3 offset;
  double unit = 1;
  Vec3 sizes;  ///< S of docs/design/culling.md: what world coordinates are rounded with
};

[[nodiscard]] NearFrame near_frame(const PosedMesh& mesh);

/// A convex shape as a tree of one box around its core, the radius left aside; a quadric is its own core.
struct ConvexNearBvh {
  explicit ConvexNearBvh(const PosedPolytope& shape);
  explicit ConvexNearBvh(const PosedQuadric& shape);
  NearFrame frame;
  OrientedBlock block{};
  Index item = 0;

  [[nodiscard]] NearBvh tree() const { return {{&block, 1}, {&item, 1}}; }

 private:
  explicit ConvexNearBvh(const Aabb& box);
};

/// The constants of a walk that sees boxes of `other` from `own`; their pads cover all that is rounded
/// (docs/methods/mesh-distance.md).
[[nodiscard]] NearView near_view(const NearFrame& own, const NearFrame& other);

}  // namespace toccata
