#include "world/character_mover/thing_planes.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "world/character_mover/face_normals.hpp"

namespace toccata {
namespace {

/// More than a height along a unit normal, and the difference of two, is off by for coordinates no greater than 1: 4
/// roundings of sums of three products, and a normal whose length is off by 2.
constexpr double height_error = 0x1p-48;

/// How far, of the extent, the corners of a face may lie below its plane; and how wide, of its longest edge, a triangle
/// has to be. Beyond that a normal and what is over a face are made of rounding, and exact distance has to decide.
constexpr double greatest_bend = 0x1p-40, least_width = 0x1p-12;

void add_plane(ThingPlanes& planes, const PosedPolytope& thing, const Vec3& normal) {
  double top = -infinity;
  for (Index i = 0; i < thing.vertex_count(); ++i) top = std::max(top, dot(normal, thing.vertex(i)));
  planes.planes[planes.count++] = {normal, top};
}

/// Where it is not so narrow that its corners are on a line, but for rounding.
void add_planes_of_triangle(ThingPlanes& planes, const Triangle& t) {
  const std::array<Vec3, 3> sides{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  const Vec3 across = cross(sides[0], t[2] - t[0]);
  const double longest_square = std::max({dot(sides[0], sides[0]), dot(sides[1], sides[1]), dot(sides[2], sides[2])});
  if (!(length(across) > least_width * longest_square)) return;
  const Vec3 normal = normalized(across);
  const auto add = [&](const Vec3& n) {
    planes.planes[planes.count++] = {n, std::max({dot(n, t[0]), dot(n, t[1]), dot(n, t[2])})};
  };
  add(normal);
  add(-normal);
  for (const Vec3& side : sides) add(normalized(cross(side, normal)));
  planes.is_triangle = true;
}

/// None where a normal is no direction.
ThingPlanes with_normals(ThingPlanes planes) {
  for (std::size_t i = 0; i < planes.count; ++i)
    if (planes.planes[i].normal == Vec3{}) planes.count = 0;
  return planes;
}

bool has_corners_in(const ThingPlanes::Plane& plane, const PosedPolytope& thing, Index face, double tolerance) {
  const HullTopology topology = thing.topology();
  for (Index edge = topology.face_start[face]; edge < topology.face_start[face + 1]; ++edge)
    if (!(dot(plane.normal, thing.vertex(topology.origin[edge])) >= plane.top - tolerance)) return false;
  return true;
}

/// None if one of them is no plane of its face.
void add_planes_of_faces(ThingPlanes& planes, const PosedPolytope& thing) {
  for (Index face = 0; face < thing.topology().face_count(); ++face) {
    add_plane(planes, thing, normal_of_face(thing, face));
    if (has_corners_in(planes.planes[face], thing, face, greatest_bend * planes.extent)) continue;
    planes.count = 0;
    return;
  }
}

bool is_over_the_rest(const Vec3& foot, const ThingPlanes& planes, std::size_t face, double slack) {
  for (std::size_t i = 0; i < planes.count; ++i)
    if (i != face && dot(planes.planes[i].normal, foot) > planes.planes[i].top + slack) return false;
  return true;
}

}  // namespace

ThingPlanes planes_of(const LevelSet& set) {
  ThingPlanes planes;
  if (const auto* half = std::get_if<PosedHalfSpace>(&set)) {
    const Vec3 normal = normalized(half->normal);
    planes.planes[planes.count++] = {normal, dot(normal, half->point)};
    planes.extent = largest_magnitude(half->point);
    return planes;
  }
  const auto* thing = std::get_if<PosedPolytope>(&set);
  if (thing == nullptr || thing->vertex_count() > 8) return planes;
  planes.radius = thing->radius();
  for (Index i = 0; i < thing->vertex_count(); ++i)
    planes.extent = std::max(planes.extent, largest_magnitude(thing->vertex(i)));
  const Index faces = thing->topology().face_count();
  if (thing->vertex_count() == 3 && faces == 2)
    add_planes_of_triangle(planes, Triangle{{thing->vertex(0), thing->vertex(1), thing->vertex(2)}});
  if (thing->vertex_count() > 3 && faces > 3 && faces <= ThingPlanes::most) add_planes_of_faces(planes, *thing);
  return with_normals(planes);
}

ThingPlanes planes_of(const Triangle& triangle) {
  ThingPlanes planes;
  for (const Vec3& corner : triangle.vertex) planes.extent = std::max(planes.extent, largest_magnitude(corner));
  add_planes_of_triangle(planes, triangle);
  return with_normals(planes);
}

void FewCorners::add(const Vec3& corner) {
  corners[count++] = corner;
  extent = std::max(extent, largest_magnitude(corner));
}

double height_slack(double extent_above, double extent_below) {
  return height_error * std::max(extent_above, extent_below);
}

double height_slack(const FewCorners& above, const ThingPlanes& planes) {
  return height_slack(above.extent, planes.extent);
}

bool passes_beside(const FewCorners& above, const Vec3& way, const ThingPlanes& planes, double distance) {
  if (!planes.is_triangle || planes.count == 0 || above.count == 0) return false;
  const double slack = height_slack(above, planes) + height_slack(largest_magnitude(way), 0);
  std::array<double, 2> least{};  // over the face, and over a side
  for (std::size_t p = 0; p < planes.count; ++p) {
    const ThingPlanes::Plane& plane = planes.planes[p];
    const double height = above.lowest_along(plane.normal) - plane.top + std::min(0.0, dot(plane.normal, way));
    double& most = least[p < 2 ? 0 : 1];
    most = std::max(most, height - 2 * slack);
  }
  const double reach = distance + planes.radius;
  return least[0] * least[0] + least[1] * least[1] > reach * reach * (1 + 0x1p-40);
}

PlaneGap plane_gap(const FewCorners& above, const ThingPlanes& planes, double enough) {
  PlaneGap best{-infinity};
  if (above.count == 0) return best;
  const double slack = height_slack(above, planes);
  std::size_t face = 0;
  for (std::size_t p = 0; p < planes.count && best.distance < enough; ++p) {
    const ThingPlanes::Plane& plane = planes.planes[p];
    const double gap = above.lowest_along(plane.normal) - plane.top - slack;
    if (!(gap > best.distance)) continue;
    best = {gap, plane.normal};
    face = p;
  }
  if (!(best.distance > 0)) return best;
  for (std::size_t i = 0; i < above.count && !best.is_exact; ++i) {
    const double height = dot(best.normal, above.corners[i]) - planes.planes[face].top;
    best.foot = above.corners[i] - height * best.normal;
    best.is_exact = height <= best.distance + 3 * slack && is_over_the_rest(best.foot, planes, face, slack);
  }
  return best;
}

}  // namespace toccata
