#include "toccata/bounds/volume.hpp"

#include "bounds/point_clouds.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/separation.hpp"
#include "math/constants.hpp"

namespace toccata {

double support_bound(const PointVolume& point, const Vec3& direction, const Vec3& from) {
  UpperSum sum;
  sum.add(direction, point.position - from);
  return sum.bound();
}

template <>
Aabb fit<Aabb>(std::span<const Vec3> points) {
  return checked_box(points);
}

template <>
Aabb fit<Aabb>(std::span<const Triangle> triangles) {
  return checked_box(corners_of(triangles));
}

double support_bound(const Aabb& box, const Vec3& direction, const Vec3& from) {
  if (is_empty(box)) return -infinity;
  UpperSum sum;
  sum.add(direction, farthest_point(box, direction) - from);
  return sum.bound();
}

Vec3 farthest_point(const Aabb& box, const Vec3& direction) {
  const auto along = [&](int axis) { return direction[axis] < 0 ? box.lower[axis] : box.upper[axis]; };
  return {along(0), along(1), along(2)};
}

Vec3 middle(const Aabb& box) { return is_empty(box) ? Vec3{} : centre_of(box); }

bool contains(const Aabb& box, const Vec3& point) { return contains(box, Aabb{point, point}); }

Aabb posed(const Aabb& box, const Pose& pose) { return posed_box(box, pose); }

double measure(const Aabb& box) {
  if (is_empty(box)) return 0;
  const Vec3 size = box.upper - box.lower;
  // A flat one has none, however large it is.
  return size.x == 0 || size.y == 0 || size.z == 0 ? 0 : size.x * size.y * size.z;
}

double surface_area(const Aabb& box) { return 2 * half_area(box); }

TOCCATA_INSTANTIATE_VOLUME(Aabb);

}  // namespace toccata
