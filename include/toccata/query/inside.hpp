#pragma once

#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

enum class Side { outside, boundary, inside };

struct PointLocation {
  Side side = Side::outside;
  /// How often the surface winds around the point; 0 is outside. On the boundary it is not defined and 0 here.
  int winding_number = 0;
};

/// Where a world point lies relative to the posed solid: on one of its faces, or inside (winding number not 0), or
/// outside. Exact. Throws Error when the mesh is open, the pose is singular, or the point or a vertex is not finite.
[[nodiscard]] PointLocation locate(const Vec3& point, const Model& solid, const Pose& pose = {});

}  // namespace toccata
