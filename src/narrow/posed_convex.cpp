#include "toccata/narrow/posed_convex.hpp"

#include <algorithm>
#include <cmath>

#include "narrow/plain_topology.hpp"
#include "narrow/pose_checks.hpp"

namespace toccata {

void PosedConvex::place(std::span<const Vec3> local, std::string_view who) {
  require_finite(pose_, who);
  count_ = static_cast<Index>(local.size());
  for (std::size_t i = 0; i < local.size(); ++i) {
    const Vec3 world = transform(pose_, local[i]);
    if (!is_finite(world)) refuse_vertex(i, local[i], pose_, who);
    for (std::size_t axis = 0; axis < 3; ++axis) few_[axis][i] = world[static_cast<int>(axis)];
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::fill(few_[axis].begin() + count_, few_[axis].end(), few_[axis][count_ - 1]);
    along_[axis] = few_[axis].data();
  }
}

PosedConvex::PosedConvex(const Point& shape, const Pose& pose) : pose_(pose), topology_(point_topology()) {
  place({{shape.position()}}, "the point");
}

PosedConvex::PosedConvex(const Segment& shape, const Pose& pose) : pose_(pose) {
  place({{shape.start(), shape.end()}}, "the segment");
  topology_ = vertex(0) == vertex(1) ? point_topology() : segment_topology();
}

PosedConvex::PosedConvex(const Triangle& shape, const Pose& pose) : pose_(pose) {
  place(shape.vertex, "the triangle");
  topology_ = triangle_topology({{vertex(0), vertex(1), vertex(2)}});
}

PosedConvex::PosedConvex(const Sphere& shape, const Pose& pose)
    : pose_(pose), topology_(point_topology()), radius_(shape.radius()), solid_(true) {
  place({{shape.centre()}}, "the sphere");
  require_undeformed(pose, "the sphere");
}

PosedConvex::PosedConvex(const Capsule& shape, const Pose& pose) : pose_(pose), radius_(shape.radius()), solid_(true) {
  place({{shape.start(), shape.end()}}, "the capsule");
  require_undeformed(pose, "the capsule");
  topology_ = vertex(0) == vertex(1) ? point_topology() : segment_topology();
}

PosedConvex::PosedConvex(const Box& shape, const Pose& pose) : pose_(pose), topology_(box_topology()), solid_(true) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = shape.corner(static_cast<int>(i));
  place(corners, "the box");
  box_ = rigid_box(shape, pose);
  if (!(box_.skew < 0x1p-4)) require_regular(pose, "the box");
}

PosedConvex::PosedConvex(const PosedConvex& other) { *this = other; }

PosedConvex& PosedConvex::operator=(const PosedConvex& other) {
  if (this == &other) return *this;
  along_ = other.along_;
  box_ = other.box_;
  pose_ = other.pose_;
  topology_ = other.topology_;
  radius_ = other.radius_;
  count_ = other.count_;
  in_world_ = other.in_world_;
  solid_ = other.solid_;
  if (!in_world_) return *this;
  few_ = other.few_;
  for (std::size_t axis = 0; axis < 3; ++axis) along_[axis] = few_[axis].data();
  return *this;
}

PosedConvex PosedConvex::moved(const Vec3& by) const {
  PosedConvex result = *this;
  result.pose_.offset = pose_.offset + by;
  result.box_ = {};
  if (!in_world_) return result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double& coordinate : result.few_[axis]) coordinate += by[static_cast<int>(axis)];
  return result;
}

PosedConvex PosedConvex::scaled(int exponent) const {
  const auto scale = [=](Vec3& v) {
    v = {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
  };
  PosedConvex result = *this;
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
