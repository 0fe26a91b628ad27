#include "bounds/point_clouds.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "toccata/core/error.hpp"

namespace toccata {

Aabb checked_box(std::span<const Vec3> points) {
  Aabb box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      // Not a number fails the comparison too.
      if (!(std::fabs(points[i][axis]) <= greatest_fitted_coordinate))
        throw Error("point " + std::to_string(i) + " has a coordinate that is not finite or above 2^1000: " +
                    "a volume cannot be fitted to it; choose a larger unit of length");
    box = merge(box, points[i]);
  }
  return box;
}

std::vector<Vec3> corners_of(std::span<const Triangle> triangles) {
  std::vector<Vec3> corners;
  corners.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) corners.insert(corners.end(), t.vertex.begin(), t.vertex.end());
  return corners;
}

CloudScale::CloudScale(const Aabb& box) {
  if (is_empty(box)) return;
  centre = centre_of(box);
  const Vec3 size = box.upper - box.lower;
  const double longest = std::max({size.x, size.y, size.z});
  // A power of two; what is smaller still than 2^-1000 stays small, but its squares do not vanish.
  factor = std::ldexp(1.0, -std::ilogb(std::max(longest, 0x1p-1000)));
}

}  // namespace toccata
