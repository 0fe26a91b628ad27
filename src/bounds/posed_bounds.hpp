#pragma once

#include "bounds/upper_sum.hpp"
#include "toccata/bounds/volume.hpp"

namespace toccata {

/// What world vertices are off by from the exact image of points within a box, and what the bounds of this room need
/// besides: along axis i a small part of Σ_j |R_ij| |x_j| + |t_i|.
Vec3 posing_slack(const Pose& pose, const Aabb& box);

/// No pose of this linear part makes a vector longer than by this factor. By a little above 1 for a rotation.
double stretch_bound(const Mat3& linear);

/// What world vertices of the points of a volume can reach.
template <SupportedVolume V>
class PosedSupport {
 public:
  PosedSupport(const V& volume, const Pose& pose)
      : volume_(volume),
        pose_(pose),
        origin_(middle(volume)),
        image_(transform(pose, origin_)),
        slack_(posing_slack(pose, merge(box_around(volume), origin_))) {}

  /// No world vertex of a point x of the volume has a greater (x − from) · direction.
  double operator()(const Vec3& direction, const Vec3& from) const {
    const Mat3& r = pose_.linear;
    const Vec3 local = (direction.x * r[0] + direction.y * r[1]) + direction.z * r[2];
    UpperSum sum;
    sum.add(direction, image_ - from);
    sum.add(1, support_bound(volume_, local, origin_));
    for (int axis = 0; axis < 3; ++axis) sum.add_slack(std::fabs(direction[axis]) * slack_[axis]);
    return sum.bound();
  }

 private:
  const V& volume_;
  const Pose& pose_;
  Vec3 origin_;
  Vec3 image_;
  Vec3 slack_;
};

template <SupportedVolume V>
Aabb posed_box(const V& volume, const Pose& pose) {
  if (is_empty(volume)) return {};
  const PosedSupport support(volume, pose);
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 direction;
    direction[axis] = 1;
    box.upper[axis] = support(direction, {});
    box.lower[axis] = -support(-direction, {});
  }
  return box;
}

}  // namespace toccata
