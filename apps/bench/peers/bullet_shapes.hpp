#pragma once

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <memory>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/primitives.hpp"
#include "toccata/shapes/shape.hpp"

// Names of its own for the linker: each peer has a `converted` of the same parameters.
namespace toccata::bench {
inline namespace bullet_shapes {

inline btVector3 converted(const Vec3& v) { return {v.x, v.y, v.z}; }

inline btTransform converted(const Pose& pose) {
  const Mat3& m = pose.linear;
  return btTransform(btMatrix3x3(m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z),
                     converted(pose.offset));
}

/// Without the margin that Bullet gives to what has corners.
template <class Shape>
std::unique_ptr<Shape> without_margin(std::unique_ptr<Shape> shape) {
  shape->setMargin(0);
  return shape;
}

inline std::unique_ptr<btSphereShape> converted(const Sphere& sphere) {
  return std::make_unique<btSphereShape>(sphere.radius());
}

inline std::unique_ptr<btBoxShape> converted(const Box& box) {
  return without_margin(std::make_unique<btBoxShape>(converted(box.half_extents())));
}

inline std::unique_ptr<btCapsuleShapeZ> converted(const Capsule& capsule) {
  return std::make_unique<btCapsuleShapeZ>(capsule.radius(), 2 * capsule.end().z);
}

inline std::unique_ptr<btTriangleShape> converted(const Triangle& t) {
  return without_margin(std::make_unique<btTriangleShape>(converted(t[0]), converted(t[1]), converted(t[2])));
}

inline std::unique_ptr<btCylinderShapeZ> converted(const Cylinder& cylinder) {
  const double radius = cylinder.radius();
  return without_margin(std::make_unique<btCylinderShapeZ>(btVector3(radius, radius, cylinder.half_height())));
}

inline std::unique_ptr<btConeShapeZ> converted(const Cone& cone) {
  return without_margin(std::make_unique<btConeShapeZ>(cone.radius(), 2 * cone.half_height()));
}

inline std::unique_ptr<btConvexHullShape> converted(const ConvexHull& hull) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (Index i = 0; i < hull.vertex_count(); ++i) shape->addPoint(converted(hull.vertex(i)), false);
  shape->recalcLocalAabb();
  return without_margin(std::move(shape));
}

}  // namespace bullet_shapes
}  // namespace toccata::bench
