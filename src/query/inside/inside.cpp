#include "toccata/query/signed_distance.hpp"

#include <fmt/format.h>

#include "query/inside/inside_winding.hpp"
#include "query/semantics.hpp"
#include "toccata/core/error.hpp"

namespace toccata {

PointLocation locate(const Vec3& point, const Model& solid, const Pose& pose) {
  if (!is_finite(point))
    throw Error(fmt::format("the point ({}, {}, {}) has a coordinate that is not finite", point.x, point.y, point.z));
  const PosedMesh posed(solid, pose, "the solid");
  static_cast<void>(taken_as_solid(solid, pose, Solid::all, "the solid"));  // throws when it cannot be one
  const LineWinding winding = wind_along(posed, ExactPoint(point), 0);
  if (winding.on_face) return {Side::boundary, 0};
  return {winding.ahead != 0 ? Side::inside : Side::outside, winding.ahead};
}

}  // namespace toccata
