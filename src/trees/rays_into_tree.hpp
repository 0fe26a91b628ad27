#pragma once

#include <span>

#include "narrow/triangles/ray_triangle.hpp"
#include "trees/ray_frame.hpp"
#include "trees/wide_ray.hpp"

namespace toccata {

/// The part of a ray that is within the box of a tree, up to what rounding adds.
struct RayInTree {
  WideRay ray;        ///< that part, in the tree's units
  double from = 0;    ///< of the whole ray
  double to = 1;      ///< less than `from` where the ray never is in the box
  bool known = true;  ///< bounds can be told; else nothing of the above is
  [[nodiscard]] bool misses() const { return from > to; }
};

[[nodiscard]] RayInTree ray_into_tree(const RayFrame& frame, const PreparedRay& ray);

/// The same for each ray; `result` is as long.
void rays_into_tree(const RayFrame& frame, std::span<const PreparedRay> rays, std::span<RayInTree> result);

}  // namespace toccata
