#include <algorithm>
#include <cmath>
#include <limits>

#include "narrow/pose_checks.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {
namespace {

/// No world vertex can be infinite where this sum is far from it.
bool may_overflow(const Pose& pose, double largest_coordinate) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3& r = pose.linear[axis];
    largest = std::max(largest, ((std::fabs(r.x) + std::fabs(r.y)) + std::fabs(r.z)) * largest_coordinate +
                                    std::fabs(pose.offset[axis]));
  }
  return !(largest < 0.25 * std::numeric_limits<double>::max());
}

}  // namespace

PosedPolytope::PosedPolytope(const ConvexHull& shape, const Pose& pose)
    : pose_(pose),
      topology_(shape.topology()),
      stored_extent_(shape.largest_coordinate()),
      count_(shape.vertex_count()),
      in_world_(false),
      solid_(shape.dimension() == 3) {
  require_finite(pose, "the hull");
  if (solid_) require_regular(pose, "the hull");
  for (std::size_t axis = 0; axis < 3; ++axis) along_[axis] = shape.padded_coordinates(static_cast<int>(axis)).data();
  if (!may_overflow(pose, shape.largest_coordinate())) return;
  for (Index i = 0; i < count_; ++i)
    if (!is_finite(vertex(i))) refuse_vertex(i, shape.vertex(i), pose, "the hull");
}

PosedPolytope::PosedPolytope(const Rounded& shape, const Pose& pose)
    : PosedPolytope(std::visit([&](const auto& core) { return PosedPolytope(core, pose); }, shape.core())) {
  require_undeformed(pose, "the rounded shape");
  radius_ = shape.radius();
  solid_ = true;
}

}  // namespace toccata
