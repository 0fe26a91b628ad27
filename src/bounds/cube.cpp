#include "toccata/bounds/all_volumes.hpp"

#include "bounds/normals.hpp"
#include "bounds/point_clouds.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/separation.hpp"
#include "math/constants.hpp"

namespace toccata {
namespace {

/// No less than the farthest that a coordinate of the point is from the centre's.
double distance_bound(const Vec3& centre, const Vec3& point) { return rounded_up(largest_magnitude(point - centre)); }

Cube around(const Aabb& box) {
  if (is_empty(box)) return {};
  const Vec3 centre = centre_of(box);
  if (!is_finite(centre)) return {{}, infinity};
  // Both corners, since rounding need not leave the centre in the middle.
  return {centre, std::max(distance_bound(centre, box.lower), distance_bound(centre, box.upper))};
}

}  // namespace

template <>
Cube fit<Cube>(std::span<const Vec3> points) {
  return around(checked_box(points));
}

template <>
Cube fit<Cube>(std::span<const Triangle> triangles) {
  return fit<Cube>(corners_of(triangles));
}

double support_bound(const Cube& cube, const Vec3& direction, const Vec3& from) {
  if (is_empty(cube)) return -infinity;
  UpperSum sum;
  sum.add(direction, cube.centre - from);
  for (int axis = 0; axis < 3; ++axis) sum.add(std::fabs(direction[axis]), cube.half);
  return sum.bound();
}

Vec3 farthest_point(const Cube& cube, const Vec3& direction) {
  const auto along = [&](int axis) { return cube.centre[axis] + (direction[axis] < 0 ? -cube.half : cube.half); };
  return {along(0), along(1), along(2)};
}

Cube merge(const Cube& a, const Cube& b) {
  if (is_empty(a) || is_empty(b)) return is_empty(a) ? b : a;
  return around(merge(box_around(a), box_around(b)));
}

bool contains(const Cube& cube, const Vec3& point) { return distance_bound(cube.centre, point) <= cube.half; }

Cube posed(const Cube& cube, const Pose& pose) { return around(posed_box(cube, pose)); }

Aabb box_around(const Cube& cube) { return box_by_supports(cube); }

double measure(const Cube& cube) { return is_empty(cube) ? 0 : 8 * cube.half * cube.half * cube.half; }
double surface_area(const Cube& cube) { return is_empty(cube) ? 0 : 24 * cube.half * cube.half; }
double half_area(const Cube& cube) { return surface_area(cube) / 2; }

TOCCATA_INSTANTIATE_VOLUME(Cube);

}  // namespace toccata
