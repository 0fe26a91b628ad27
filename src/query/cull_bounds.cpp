#include "query/cull_bounds.hpp"

#include <cmath>

namespace toccata {

Vec3 largest_coordinates(const PosedMesh& mesh) {
  const Aabb& box = mesh.model().tree().nodes.front().volume;
  Vec3 largest;
  for (int axis = 0; axis < 3; ++axis) largest[axis] = std::max(std::abs(box.lower[axis]), std::abs(box.upper[axis]));
  return largest;
}

Vec3 world_sizes(const PosedMesh& mesh) {
  const Vec3 rho = largest_coordinates(mesh);
  Vec3 sizes;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3& row = mesh.pose().linear[axis];
    sizes[axis] = ((std::abs(row.x) * rho.x + std::abs(row.y) * rho.y) + std::abs(row.z) * rho.z) +
                  std::abs(mesh.pose().offset[axis]);
  }
  return sizes;
}

}  // namespace toccata
