#include <utility>

#include "math/constants.hpp"
#include "methods/bsp/bsp_sweep.hpp"
#include "narrow/triangles/ray_triangle.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {
namespace {

/// The least by (upper, triangle), as of TriangleHit.
struct EarliestTriangle {
  RayTime time;
  Index triangle = 0;
  double lower = infinity;  ///< the exact first time lies in [lower, time.upper]

  void take(const RayTime& other, Index number) {
    lower = std::min(lower, other.lower);
    if (time.hit && std::pair(other.upper, number) >= std::pair(time.upper, triangle)) return;
    time = other;
    triangle = number;
  }
};

EarliestTriangle earliest(const BspTree::Parts& parts, const PreparedRay& ray) {
  EarliestTriangle found;
  BspSweep(parts, ray.origin, ray.motion).run([&](Index triangle, const BspStretch&) {
    const RayTime time = ray_time(ray, parts.planes.triangle(triangle));
    if (time.hit) found.take(time, triangle);
    return found.time.hit ? found.time.upper : 1;
  });
  return found;
}

}  // namespace

std::optional<RayHit> BspTree::cast_ray(const Vec3& origin, const Vec3& motion) const {
  const PreparedRay ray(origin, motion);
  RayHit result;
  if (locate(origin).side == Side::inside) {
    result.point = origin;
    return result;
  }
  const EarliestTriangle found = earliest(*parts_, ray);
  if (!found.time.hit) return {};
  static_cast<Cast&>(result) = ray_hit(ray, parts_->planes.triangle(found.triangle), found.time);
  result.lower = found.lower;
  result.element = found.triangle;
  result.face = parts_->planes.mesh().face_of(found.triangle);
  return result;
}

bool BspTree::overlap(const Vec3& from, const Vec3& to) const {
  require_finite_point(from);
  require_finite_point(to);
  if (!is_finite(to - from))
    throw Error("the ends of the segment are farther apart along an axis than the greatest double");
  if (locate(from).side != Side::outside) return true;
  if (from == to) return false;
  const PreparedRay ray(from, to - from);
  const Triangle segment{from, to, to};
  bool met = false;
  BspSweep(*parts_, ray.origin, ray.motion).run([&](Index triangle, const BspStretch&) {
    met = met || toccata::overlap(segment, parts_->planes.triangle(triangle));
    return met ? -infinity : 1;
  });
  return met;
}

}  // namespace toccata
