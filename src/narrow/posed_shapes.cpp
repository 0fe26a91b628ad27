#include "toccata/narrow/posed_shapes.hpp"

#include <cmath>

#include "narrow/pose_checks.hpp"

namespace toccata {
namespace {

Vec3 world_vertex(std::size_t number, const Vec3& local, const Pose& pose, std::string_view who) {
  const Vec3 world = transform(pose, local);
  if (!is_finite(world)) refuse_vertex(number, local, pose, who);
  return world;
}

double sum_of_magnitudes(const Vec3& v) { return (std::fabs(v.x) + std::fabs(v.y)) + std::fabs(v.z); }

/// A corner is rounded once in its own frame, and in the world three times in each product and twice more: eight times
/// 2^-53 of the magnitudes that meet in a coordinate. The formulas' centre and half axes are rounded as often. Summed
/// over the axes, 32 · 2^-53 covers both; underflow loses less than 2^-1000.
double slack_of_corners(const Box& box, const Pose& pose) {
  double magnitude = sum_of_magnitudes(pose.offset);
  for (int axis = 0; axis < 3; ++axis)
    magnitude += sum_of_magnitudes(pose.linear.column(axis)) *
                 (std::fabs(box.centre()[axis]) + std::fabs(box.half_extents()[axis]));
  return 0x1p-48 * magnitude + 0x1p-1000;
}

}  // namespace

PosedSphere::PosedSphere(const Sphere& shape, const Pose& pose) : radius(shape.radius()) {
  require_finite(pose, "the sphere");
  require_undeformed(pose, "the sphere");
  centre = world_vertex(0, shape.centre(), pose, "the sphere");
}

PosedCapsule::PosedCapsule(const Capsule& shape, const Pose& pose) : radius(shape.radius()) {
  require_finite(pose, "the capsule");
  require_undeformed(pose, "the capsule");
  start = world_vertex(0, shape.start(), pose, "the capsule");
  end = world_vertex(1, shape.end(), pose, "the capsule");
}

PosedBox::PosedBox(const Box& box, const Pose& box_pose) : shape(box), pose(box_pose) {
  require_finite(pose, "the box");
  rigid = rigid_box(box, pose);
  if (!(rigid.skew < 0x1p-4)) require_regular(pose, "the box");
  centre = rigid.centre;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3& along = half_axis[static_cast<std::size_t>(axis)];
    along = box.half_extents()[axis] * pose.linear.column(axis);
    inverse_squared[axis] = 1 / dot(along, along);
    size += sum_of_magnitudes(along);
  }
  corner_slack = slack_of_corners(box, pose);
  const bool surely_finite = sum_of_magnitudes(centre) + size + corner_slack < 0x1p1000;
  for (int i = 0; i < 8 && !surely_finite; ++i)
    static_cast<void>(world_vertex(static_cast<std::size_t>(i), box.corner(i), pose, "the box"));
}

}  // namespace toccata
