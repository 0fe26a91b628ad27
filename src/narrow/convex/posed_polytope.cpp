#include "toccata/narrow/posed_polytope.hpp"

#include <cmath>

#include "math/world_vertex.hpp"
#include "narrow/boxes/box_corners.hpp"
#include "narrow/convex/plain_topology.hpp"
#include "narrow/pose_checks.hpp"

namespace toccata {

template <std::size_t count>
void PosedPolytope::place(const std::array<Vec3, count>& local, std::string_view who, Bound bound) {
  static_assert(count <= 8);
  count_ = static_cast<Index>(count);
  bool finite = true;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 world = world_vertex(pose_, local[i]);
    finite = finite && is_surely_finite(world);
    for (std::size_t axis = 0; axis < 3; ++axis) few_[axis][i] = world[static_cast<int>(axis)];
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = count; i < 8; ++i) few_[axis][i] = few_[axis][count - 1];
    along_[axis] = few_[axis].data();
  }
  // Where a world vertex is finite, so is the offset of the pose.
  if (!finite || !is_surely_rigid(pose_.linear)) check(local, who, bound);
}

void PosedPolytope::check(std::span<const Vec3> local, std::string_view who, Bound bound) const {
  require_finite(pose_, who);
  for (std::size_t i = 0; i < local.size(); ++i)
    if (!is_finite(vertex(static_cast<Index>(i)))) refuse_vertex(i, local[i], pose_, who);
  if (bound == Bound::undeformed) require_undeformed(pose_, who);
  if (bound == Bound::regular) require_regular(pose_, who);
}

PosedPolytope::PosedPolytope(const Point& shape, const Pose& pose) : pose_(pose), topology_(point_topology()) {
  place<1>({shape.position()}, "the point", Bound::none);
}

PosedPolytope::PosedPolytope(const Segment& shape, const Pose& pose) : pose_(pose) {
  place<2>({shape.start(), shape.end()}, "the segment", Bound::none);
  topology_ = vertex(0) == vertex(1) ? point_topology() : segment_topology();
}

PosedPolytope::PosedPolytope(const Triangle& shape, const Pose& pose) : pose_(pose) {
  place(shape.vertex, "the triangle", Bound::none);
  topology_ = triangle_topology({{vertex(0), vertex(1), vertex(2)}});
}

PosedPolytope::PosedPolytope(const Sphere& shape, const Pose& pose)
    : pose_(pose), topology_(point_topology()), radius_(shape.radius()), solid_(true) {
  place<1>({shape.centre()}, "the sphere", Bound::undeformed);
}

PosedPolytope::PosedPolytope(const Capsule& shape, const Pose& pose)
    : pose_(pose), radius_(shape.radius()), solid_(true) {
  place<2>({shape.start(), shape.end()}, "the capsule", Bound::undeformed);
  topology_ = vertex(0) == vertex(1) ? point_topology() : segment_topology();
}

PosedPolytope::PosedPolytope(const Box& shape, const Pose& pose)
    : pose_(pose), topology_(box_topology()), count_(8), solid_(true) {
  const Vec3 sum = place_corners(shape, pose, few_);
  for (std::size_t axis = 0; axis < 3; ++axis) along_[axis] = few_[axis].data();
  box_ = rigid_box(shape, pose);
  // A pose of so little skew is finite and not singular.
  if (box_.skew < 0x1p-4 && is_surely_finite(sum)) return;
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = shape.corner(static_cast<int>(i));
  check(corners, "the box", Bound::regular);
}

PosedPolytope::PosedPolytope(const PosedPolytope& other) { *this = other; }

PosedPolytope& PosedPolytope::operator=(const PosedPolytope& other) {
  if (this == &other) return *this;
  along_ = other.along_;
  box_ = other.box_;
  pose_ = other.pose_;
  topology_ = other.topology_;
  radius_ = other.radius_;
  stored_extent_ = other.stored_extent_;
  count_ = other.count_;
  in_world_ = other.in_world_;
  solid_ = other.solid_;
  if (!in_world_) return *this;
  few_ = other.few_;
  for (std::size_t axis = 0; axis < 3; ++axis) along_[axis] = few_[axis].data();
  return *this;
}

PosedPolytope PosedPolytope::moved(const Vec3& by) const {
  PosedPolytope result = *this;
  result.pose_.offset = pose_.offset + by;
  result.box_ = {};
  if (!in_world_) return result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double& coordinate : result.few_[axis]) coordinate += by[static_cast<int>(axis)];
  return result;
}

PosedPolytope PosedPolytope::scaled(int exponent) const {
  const auto scale = [=](Vec3& v) {
    v = {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
  };
  PosedPolytope result = *this;
  scale(result.pose_.offset);
  result.radius_ = std::scalbn(radius_, exponent);
  result.box_ = {};
  if (!in_world_) {
    for (int row = 0; row < 3; ++row) scale(result.pose_.linear[row]);
    return result;
  }
  for (auto& coordinates : result.few_)
    for (double& coordinate : coordinates) coordinate = std::scalbn(coordinate, exponent);
  return result;
}

}  // namespace toccata
