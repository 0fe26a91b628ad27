#pragma once

#include <ode/ode.h>

#include <memory>

#include "toccata/math/pose.hpp"
#include "toccata/shapes/primitives.hpp"
#include "toccata/shapes/shape.hpp"

// Names of its own for the linker: each peer has a `converted` of the same parameters.
namespace toccata::bench {
inline namespace ode_shapes {

/// ODE is set up and closed once for the whole program.
class OdeEngine {
 public:
  OdeEngine() { dInitODE2(0); }
  ~OdeEngine() { dCloseODE(); }
  OdeEngine(const OdeEngine&) = delete;
  OdeEngine& operator=(const OdeEngine&) = delete;
};

struct Destroy {
  void operator()(dxGeom* geometry) const { dGeomDestroy(geometry); }
};
using Geometry = std::unique_ptr<dxGeom, Destroy>;

inline Geometry converted(const Sphere& sphere) { return Geometry(dCreateSphere(nullptr, sphere.radius())); }

inline Geometry converted(const Box& box) {
  const Vec3& half = box.half_extents();
  return Geometry(dCreateBox(nullptr, 2 * half.x, 2 * half.y, 2 * half.z));
}

inline Geometry converted(const Capsule& capsule) {
  return Geometry(dCreateCapsule(nullptr, capsule.radius(), 2 * capsule.end().z));
}

inline Geometry converted(const Cylinder& cylinder) {
  return Geometry(dCreateCylinder(nullptr, cylinder.radius(), 2 * cylinder.half_height()));
}

inline dxGeom* place(dxGeom* geometry, const Pose& pose) {
  const Mat3& m = pose.linear;
  const dMatrix3 rotation{m[0].x, m[0].y, m[0].z, 0, m[1].x, m[1].y, m[1].z, 0, m[2].x, m[2].y, m[2].z, 0};
  dGeomSetPosition(geometry, pose.offset.x, pose.offset.y, pose.offset.z);
  dGeomSetRotation(geometry, rotation);
  return geometry;
}

}  // namespace ode_shapes
}  // namespace toccata::bench
