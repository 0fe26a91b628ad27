#pragma once

#include <span>

#include "narrow/triangles/ray_triangle.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/math/mat3.hpp"
#include "trees/wide_ray.hpp"

namespace toccata {

/// How rays of the world come into the units of a tree, from its origin: docs/design/rays.md, whose names and bounds
/// these are.
struct RayFrame {
  Mat3 back;               ///< about the inverse of the pose's matrix, in the tree's units
  Vec3 offset;             ///< of the pose
  Vec3 origin;             ///< of the tree, in its units
  Aabb box;                ///< of the tree, in its units
  double off = 0;          ///< what a point is off by
  double off_by_size = 0;  ///< and what more of it, for each unit of the greatest coordinate in the world
  bool has_units = true;   ///< the tree's coordinates are at most 1
};

/// The part of a ray that is within the box of a tree, up to what rounding adds.
struct RayInTree {
  WideRay ray;        ///< that part, in the tree's units
  double from = 0;    ///< of the whole ray
  double to = 1;      ///< less than `from` where the ray never is in the box
  bool known = true;  ///< bounds can be told; else nothing of the above is
  [[nodiscard]] bool misses() const { return from > to; }
};

/// Of each ray; `result` is as long.
void rays_into_tree(const RayFrame& frame, std::span<const PreparedRay> rays, std::span<RayInTree> result);

}  // namespace toccata
