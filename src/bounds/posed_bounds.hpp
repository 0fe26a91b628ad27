#pragma once

#include "bounds/upper_sum.hpp"
#include "toccata/bounds/volume.hpp"

namespace toccata {

/// What world vertices are off by from the exact image of points within a box, and what the bounds of this room need
/// besides: along axis i a small part of Σ_j |R_ij| |x_j| + |t_i|.
Vec3 posing_slack(const Pose& pose, const Aabb& box);

/// No pose of this linear part makes a vector longer than by this factor. By a little above 1 for a rotation.
double stretch_bound(const Mat3& linear);

/// No world vertex of a point x of the volume has a greater (x − from) · direction.
template <SupportedVolume V>
double posed_support(const V& volume, const Pose& pose, const Vec3& direction, const Vec3& from) {
  const Mat3& r = pose.linear;
  const Vec3 local = (direction.x * r[0] + direction.y * r[1]) + direction.z * r[2];
  const Vec3 origin = middle(volume), slack = posing_slack(pose, merge(box_around(volume), origin));
  UpperSum sum;
  sum.add(direction, transform(pose, origin) - from);
  sum.add(1, support_bound(volume, local, origin));
  for (int axis = 0; axis < 3; ++axis) sum.add_slack(std::fabs(direction[axis]) * slack[axis]);
  return sum.bound();
}

template <SupportedVolume V>
Aabb posed_box(const V& volume, const Pose& pose) {
  if (is_empty(volume)) return {};
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 direction;
    direction[axis] = 1;
    box.upper[axis] = posed_support(volume, pose, direction, {});
    box.lower[axis] = -posed_support(volume, pose, -direction, {});
  }
  return box;
}

}  // namespace toccata
