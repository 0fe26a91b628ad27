#include "world/character_mover/thing_planes.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "world/character_mover/face_normals.hpp"

namespace toccata {
namespace {

/// How far, of the extent, the corners of a face may lie below its plane; and how wide, of its longest edge, a triangle
/// has to be. Beyond that a normal and what is over a face are made of rounding, and exact distance has to decide.
constexpr double greatest_bend = 0x1p-40, least_width = 0x1p-12;

void add_plane(ThingPlanes& planes, const PosedPolytope& thing, const Vec3& normal) {
  double top = -infinity;
  for (Index i = 0; i < thing.vertex_count(); ++i) top = std::max(top, dot(normal, thing.vertex(i)));
  planes.planes[planes.count++] = {normal, top};
}

std::array<Vec3, 3> sides_of(const Triangle& t) { return {t[1] - t[0], t[2] - t[1], t[0] - t[2]}; }

ThingPlanes::Plane plane_over(const Triangle& t, const Vec3& normal) {
  return {normal, std::max({dot(normal, t[0]), dot(normal, t[1]), dot(normal, t[2])})};
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
  if (thing->vertex_count() == 3 && faces == 2) {
    const double radius = planes.radius;
    planes = planes_of(Triangle{{thing->vertex(0), thing->vertex(1), thing->vertex(2)}});
    planes.radius = radius;
  }
  if (thing->vertex_count() > 3 && faces > 3 && faces <= ThingPlanes::most) add_planes_of_faces(planes, *thing);
  return with_normals(planes);
}

/// Where it is not so narrow that its corners are on a line, but for rounding.
TriangleFace face_of(const Triangle& t) {
  TriangleFace face;
  for (const Vec3& corner : t.vertex) face.extent = std::max(face.extent, largest_magnitude(corner));
  const std::array<Vec3, 3> sides = sides_of(t);
  const Vec3 across = cross(sides[0], t[2] - t[0]);
  const double longest_square = std::max({dot(sides[0], sides[0]), dot(sides[1], sides[1]), dot(sides[2], sides[2])});
  if (!(length(across) > least_width * longest_square)) return face;
  const Vec3 normal = normalized(across);
  face.upper = plane_over(t, normal);
  face.lower = plane_over(t, -normal);
  face.is_told = !(normal == Vec3{});
  return face;
}

ThingPlanes planes_of(const Triangle& triangle, const TriangleFace& face) {
  ThingPlanes planes;
  planes.extent = face.extent;
  planes.is_triangle = true;
  if (!face.is_told) return planes;
  planes.planes[0] = face.upper;
  planes.planes[1] = face.lower;
  planes.count = 2;
  for (const Vec3& side : sides_of(triangle))
    planes.planes[planes.count++] = plane_over(triangle, normalized(cross(side, face.upper.normal)));
  return with_normals(planes);
}

ThingPlanes planes_of(const Triangle& triangle) { return planes_of(triangle, face_of(triangle)); }

double height_slack(const FewCorners& above, const ThingPlanes& planes) {
  return height_slack(above.extent, planes.extent);
}

PlaneGap plane_gap(const FewCorners& above, const ThingPlanes& planes) {
  PlaneGap best{-infinity};
  if (above.count == 0) return best;
  const double slack = height_slack(above, planes);
  std::size_t face = 0;
  for (std::size_t p = 0; p < planes.count; ++p) {
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
