#pragma once

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>

#include <memory>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/primitives.hpp"
#include "toccata/shapes/shape.hpp"

// Names of its own for the linker: each peer has a `converted` of the same parameters.
namespace toccata::bench {
inline namespace fcl_shapes {

inline fcl::Vector3d converted(const Vec3& v) { return {v.x, v.y, v.z}; }

inline fcl::Transform3d converted(const Pose& pose) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) result.linear()(i, j) = pose.linear[i][j];
  result.translation() = converted(pose.offset);
  return result;
}

inline fcl::Sphered converted(const Sphere& sphere) { return fcl::Sphered(sphere.radius()); }

inline fcl::Boxd converted(const Box& box) {
  const Vec3& half = box.half_extents();
  return {2 * half.x, 2 * half.y, 2 * half.z};
}

inline fcl::Capsuled converted(const Capsule& capsule) { return {capsule.radius(), 2 * capsule.end().z}; }

inline fcl::Cylinderd converted(const Cylinder& cylinder) { return {cylinder.radius(), 2 * cylinder.half_height()}; }

inline fcl::Coned converted(const Cone& cone) { return {cone.radius(), 2 * cone.half_height()}; }

inline fcl::Ellipsoidd converted(const Ellipsoid& ellipsoid) {
  return fcl::Ellipsoidd(converted(ellipsoid.half_axes()));
}

inline fcl::Convexd converted(const ConvexHull& hull) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (Index i = 0; i < hull.vertex_count(); ++i) vertices->push_back(converted(hull.vertex(i)));
  auto faces = std::make_shared<std::vector<int>>();
  const HullTopology topology = hull.topology();
  for (Index f = 0; f < topology.face_count(); ++f) {
    faces->push_back(static_cast<int>(topology.face_start[f + 1] - topology.face_start[f]));
    for (Index e = topology.face_start[f]; e < topology.face_start[f + 1]; ++e)
      faces->push_back(static_cast<int>(topology.origin[e]));
  }
  return {vertices, static_cast<int>(topology.face_count()), faces};
}

}  // namespace fcl_shapes
}  // namespace toccata::bench
