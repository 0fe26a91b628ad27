#include "toccata/narrow/posed_shapes.hpp"

#include <cmath>

#include "math/vec3_measures.hpp"
#include "math/world_vertex.hpp"
#include "narrow/pose_checks.hpp"

namespace toccata {
namespace {

void require_vertex(std::size_t number, const Vec3& local, const Pose& pose, std::string_view who) {
  if (!is_finite(world_vertex(pose, local))) refuse_vertex(number, local, pose, who);
}

void require_ball(const Pose& pose, std::string_view who) {
  require_finite(pose, who);
  require_undeformed(pose, who);
}

/// A corner is rounded once in its own frame, and in the world three times in each product and twice more: eight times
/// 2^-53 of the magnitudes that meet in a coordinate. The formulas' centre and half axes are rounded as often. Summed
/// over the axes, 32 · 2^-53 covers both; underflow loses less than 2^-1000.
double slack_of_corners(const Pose& pose, const Vec3& centre, double size) {
  double magnitude = sum_of_magnitudes(pose.offset) + size;
  if (centre != Vec3{})
    for (int axis = 0; axis < 3; ++axis)
      magnitude += sum_of_magnitudes(pose.linear.column(axis)) * std::fabs(centre[axis]);
  return 0x1p-48 * magnitude + 0x1p-1000;
}

}  // namespace

// Where a world vertex is finite, so is the offset of the pose.

PosedSphere::PosedSphere(const Sphere& shape, const Pose& pose)
    : centre(world_vertex(pose, shape.centre())), radius(shape.radius()) {
  if (is_surely_rigid(pose.linear) && is_surely_finite(centre)) return;
  require_ball(pose, "the sphere");
  require_vertex(0, shape.centre(), pose, "the sphere");
}

PosedCapsule::PosedCapsule(const Capsule& shape, const Pose& pose)
    : start(world_vertex(pose, shape.start())), end(world_vertex(pose, shape.end())), radius(shape.radius()) {
  if (is_surely_rigid(pose.linear) && is_surely_finite(start) && is_surely_finite(end)) return;
  require_ball(pose, "the capsule");
  require_vertex(0, shape.start(), pose, "the capsule");
  require_vertex(1, shape.end(), pose, "the capsule");
}

PosedBox::PosedBox(const Box& box, const Pose& box_pose)
    : pose(box_pose),
      rigid(rigid_box(box, box_pose)),
      shape(box),
      centre(rigid.centre),
      half_axis{box.half_extents().x * box_pose.linear.column(0), box.half_extents().y * box_pose.linear.column(1),
                box.half_extents().z * box_pose.linear.column(2)},
      inverse_squared{1 / dot(half_axis[0], half_axis[0]), 1 / dot(half_axis[1], half_axis[1]),
                      1 / dot(half_axis[2], half_axis[2])},
      size((sum_of_magnitudes(half_axis[0]) + sum_of_magnitudes(half_axis[1])) + sum_of_magnitudes(half_axis[2])),
      corner_slack(slack_of_corners(box_pose, box.centre(), size)) {
  if (!(rigid.skew < 0x1p-4)) {
    require_finite(pose, "the box");
    require_regular(pose, "the box");
  }
  if (sum_of_magnitudes(centre) + size + corner_slack < 0x1p1000) return;
  require_finite(pose, "the box");
  for (int i = 0; i < 8; ++i) require_vertex(static_cast<std::size_t>(i), box.corner(i), pose, "the box");
}

}  // namespace toccata
