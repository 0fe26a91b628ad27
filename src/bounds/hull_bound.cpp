#include "toccata/bounds/all_volumes.hpp"

#include <vector>

#include "bounds/point_clouds.hpp"
#include "bounds/posed_bounds.hpp"
#include "bounds/separation.hpp"
#include "math/constants.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

std::vector<Vec3> vertices_of(const ConvexHull& hull) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(hull.vertex(i));
  return vertices;
}

/// No gap, or one less the margins.
double less_margins(double distance, double margins) { return rounded_down(distance - rounded_up(margins)); }

/// Measured from the vector areas of the faces, which are convex polygons, and the cones over them.
struct HullMeasure {
  double volume = 0;
  double area = 0;
};

/// In units of 1 / factor.
HullMeasure measure_of(const ConvexHull& hull, double factor) {
  const HullTopology topology = hull.topology();
  const auto vertex = [&](Index half_edge) {
    return factor * (hull.vertex(topology.origin[half_edge]) - hull.vertex(0));
  };
  HullMeasure sum;
  for (Index face = 0; face < topology.face_count(); ++face) {
    const Index first = topology.face_start[face], end = topology.face_start[face + 1];
    Vec3 normal;
    for (Index i = first + 1; i + 1 < end; ++i)
      normal = normal + cross(vertex(i) - vertex(first), vertex(i + 1) - vertex(first));
    sum.area += std::sqrt(dot(normal, normal)) / 2;
    sum.volume += dot(normal, vertex(first)) / 6;
  }
  // Rounding may turn one that is nearly flat inside out.
  sum.volume = std::max(sum.volume, 0.0);
  return sum;
}

double unit_of(const ConvexHull& hull) {
  Aabb box;
  for (const Vec3& p : vertices_of(hull)) box = merge(box, p);
  return CloudScale(box).factor;
}

}  // namespace

template <>
HullBound fit<HullBound>(std::span<const Vec3> points) {
  if (is_empty(checked_box(points))) return {};
  return {ConvexHull(points), 0};
}

template <>
HullBound fit<HullBound>(std::span<const Triangle> triangles) {
  return fit<HullBound>(corners_of(triangles));
}

double support_bound(const HullBound& v, const Vec3& direction, const Vec3& from) {
  double bound = -infinity;
  if (is_empty(v)) return bound;
  for (Index i = 0; i < v.hull->vertex_count(); ++i)
    bound = std::max(bound, support_bound(PointVolume{v.hull->vertex(i)}, direction, from));
  UpperSum sum;
  sum.add(1, bound);
  sum.add(v.margin, length_bound(direction));
  return v.margin > 0 ? sum.bound() : bound;
}

Vec3 farthest_point(const HullBound& v, const Vec3& direction) {
  Vec3 farthest = v.hull->vertex(0);
  for (Index i = 1; i < v.hull->vertex_count(); ++i)
    if (const Vec3 next = v.hull->vertex(i); dot(next, direction) > dot(farthest, direction)) farthest = next;
  return farthest;
}

Vec3 middle(const HullBound& v) { return middle(box_around(v)); }

HullBound merge(const HullBound& a, const HullBound& b) {
  if (is_empty(a) || is_empty(b)) return is_empty(a) ? b : a;
  std::vector<Vec3> vertices = vertices_of(*a.hull);
  for (const Vec3& vertex : vertices_of(*b.hull)) vertices.push_back(vertex);
  return {ConvexHull(vertices), std::max(a.margin, b.margin)};
}

bool contains(const HullBound& v, const Vec3& point) {
  if (is_empty(v) || !is_finite(point)) return false;
  const PosedPolytope hull(*v.hull), place(Point{point});
  return v.margin > 0 ? distance(place, hull).upper <= v.margin : overlap(place, hull);
}

bool overlap(const HullBound& a, const HullBound& b) {
  if (is_empty(a) || is_empty(b)) return false;
  const PosedPolytope hull_a(*a.hull), hull_b(*b.hull);
  const double margins = a.margin + b.margin;
  return margins > 0 ? distance(hull_a, hull_b).lower <= rounded_up(margins) : overlap(hull_a, hull_b);
}

double gap(const HullBound& a, const HullBound& b) {
  if (is_empty(a) || is_empty(b)) return infinity;
  return less_margins(distance(PosedPolytope(*a.hull), PosedPolytope(*b.hull)).lower, a.margin + b.margin);
}

HullBound posed(const HullBound& v, const Pose& pose) {
  if (is_empty(v)) return {};
  const std::vector<Vec3> vertices = transform(pose, vertices_of(*v.hull));
  for (const Vec3& vertex : vertices)
    if (!is_finite(vertex)) return {v.hull, infinity};
  const double slack = length_bound(posing_slack(pose, box_around(v)));
  return {ConvexHull(vertices), rounded_up(stretch_bound(pose.linear) * v.margin + slack)};
}

Aabb box_around(const HullBound& v) {
  if (is_empty(v)) return {};
  Aabb box;
  for (const Vec3& vertex : vertices_of(*v.hull)) box = merge(box, vertex);
  if (!(v.margin > 0)) return box;
  for (int axis = 0; axis < 3; ++axis) {
    UpperSum upper, lower;
    upper.add(1, box.upper[axis]);
    upper.add(1, v.margin);
    lower.add(-1, box.lower[axis]);
    lower.add(1, v.margin);
    box.upper[axis] = upper.bound();
    box.lower[axis] = -lower.bound();
  }
  return box;
}

double measure(const ConvexHull& hull) {
  const double factor = unit_of(hull), size = 1 / factor;
  return measure_of(hull, factor).volume * size * size * size;
}

double surface_area(const ConvexHull& hull) {
  const double factor = unit_of(hull), size = 1 / factor;
  return measure_of(hull, factor).area * size * size;
}

double measure(const HullBound& v) { return is_empty(v) ? 0 : measure(*v.hull); }
double surface_area(const HullBound& v) { return is_empty(v) ? 0 : surface_area(*v.hull); }
double half_area(const HullBound& v) { return surface_area(v) / 2; }

template double gap(const HullBound&, const PointVolume&);
template double gap(const PointVolume&, const HullBound&);
template bool overlap(const HullBound&, const PointVolume&);
template bool overlap(const PointVolume&, const HullBound&);
template double sweep_entry(const HullBound&, const Vec3&, const HullBound&);
template double sweep_entry(const HullBound&, const Vec3&, const PointVolume&);
template double sweep_entry(const PointVolume&, const Vec3&, const HullBound&);
static_assert(BoundingVolume<HullBound>);

}  // namespace toccata
