#include "query/meshes/cull_bounds.hpp"

#include <cmath>

namespace toccata {

Vec3 largest_coordinates(const Aabb& box) {
  Vec3 largest;
  for (int axis = 0; axis < 3; ++axis) largest[axis] = std::max(std::abs(box.lower[axis]), std::abs(box.upper[axis]));
  return largest;
}

Vec3 world_sizes(const Pose& pose, const Aabb& local) {
  const Vec3 rho = largest_coordinates(local);
  Vec3 sizes;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3& row = pose.linear[axis];
    sizes[axis] =
        ((std::abs(row.x) * rho.x + std::abs(row.y) * rho.y) + std::abs(row.z) * rho.z) + std::abs(pose.offset[axis]);
  }
  return sizes;
}

Vec3 largest_coordinates(const PosedMesh& mesh) { return largest_coordinates(mesh.model().wide_bvh().box); }

Vec3 world_sizes(const PosedMesh& mesh) { return world_sizes(mesh.pose(), mesh.model().wide_bvh().box); }

}  // namespace toccata
