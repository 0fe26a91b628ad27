#include "narrow/convex_containment.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "math/filter.hpp"
#include "math/wide_integer.hpp"
#include "narrow/exact_distance.hpp"
#include "shapes/hull_walk.hpp"

// Of A grown by r and B grown by s, a common part of the radii may be taken off both (cancellation law of Minkowski
// sums of compact convex sets). With r ≤ s, A lies in B grown by s − r: every vertex of A is that near to B, whose
// growth is convex. With r > s, A grown by r − s lies in B: no facet's plane is nearer to a vertex of A than that.
namespace toccata {
namespace {

/// The hull in the world: there rounding may have bent the shape's own faces.
ConvexHull world_hull(const PosedConvex& shape) {
  std::vector<Vec3> vertices(shape.vertex_count());
  for (Index i = 0; i < shape.vertex_count(); ++i) vertices[i] = shape.vertex(i);
  return ConvexHull(vertices);
}

struct Bounds {
  Vec3 lower;
  Vec3 upper;
};

Bounds bounds_of(const PosedConvex& shape) {
  Bounds bounds{shape.vertex(0), shape.vertex(0)};
  for (Index i = 1; i < shape.vertex_count(); ++i) {
    const Vec3 v = shape.vertex(i);
    for (int axis = 0; axis < 3; ++axis) {
      bounds.lower[axis] = std::min(bounds.lower[axis], v[axis]);
      bounds.upper[axis] = std::max(bounds.upper[axis], v[axis]);
    }
  }
  return bounds;
}

/// A reaches beyond B along an axis. A rounded sum of two doubles is monotone, so a greater one is one of greater sums.
bool certainly_sticks_out(const PosedConvex& a, const PosedConvex& b) {
  const Bounds of_a = bounds_of(a), of_b = bounds_of(b);
  for (int axis = 0; axis < 3; ++axis) {
    if (of_a.upper[axis] + a.radius() > of_b.upper[axis] + b.radius()) return true;
    if (of_a.lower[axis] - a.radius() < of_b.lower[axis] - b.radius()) return true;
  }
  return false;
}

/// The sign of (distance of the point from the plane of a, b, c) − (x − y), where x > y, for a point behind it.
Sign compare_depth(const std::array<Vec3, 3>& plane, const Vec3& point, double x, double y) {
  const std::array<Vec3, 6> all{plane[0], plane[1], plane[2], point, Vec3{x, 0, 0}, Vec3{y, 0, 0}};
  const int exponent = common_exponent(all);
  const IntegerVector origin = scaled_wide(plane[0], exponent);
  const IntegerVector normal =
      cross(scaled_wide(plane[1], exponent) - origin, scaled_wide(plane[2], exponent) - origin);
  const WideInteger height = dot(normal, scaled_wide(point, exponent) - origin);
  const WideInteger depth = scaled_wide(x, exponent) - scaled_wide(y, exponent);
  const int order = WideInteger(height * height).compare(depth * depth * dot(normal, normal));
  return static_cast<Sign>(order < 0 ? -1 : order > 0 ? 1 : 0);
}

enum class Boundary { allowed, excluded };

/// For every facet of B: the vertex of A that is highest above it lies behind it, and if r > s by at least r − s.
bool is_behind_facets(const ConvexHull& a, double r, const ConvexHull& b, double s, Boundary boundary) {
  const HullTopology t = b.topology();
  Index highest = 0;
  for (Index f = 0; f < t.face_count(); ++f) {
    const Index first = t.face_start[f];
    const std::array<Vec3, 3> plane{b.vertex(t.origin[first]), b.vertex(t.origin[first + 1]),
                                    b.vertex(t.origin[first + 2])};
    highest = highest_vertex(a, plane[0], plane[1], plane[2], highest);
    const Sign side = orient3d(plane[0], plane[1], plane[2], a.vertex(highest));
    if (side == Sign::positive || (side == Sign::zero && boundary == Boundary::excluded)) return false;
    if (r > s && compare_depth(plane, a.vertex(highest), r, s) == Sign::negative) return false;
  }
  return true;
}

/// Every vertex of A has at most the distance s − r ≥ 0 from the core of B, or less.
bool is_near_core(const PosedConvex& a, const PosedConvex& b, Boundary boundary) {
  for (Index i = 0; i < a.vertex_count(); ++i) {
    const PosedConvex vertex{Point(a.vertex(i))};
    VertexPairs start;
    start.append(0, 0);
    const Sign order = compare_core_distance(exact_nearest(vertex, b, start), b.radius(), -a.radius());
    if (order == Sign::positive || (order == Sign::zero && boundary == Boundary::excluded)) return false;
  }
  return true;
}

bool is_within(const PosedConvex& a, const PosedConvex& b, Boundary boundary) {
  if (certainly_sticks_out(a, b)) return false;
  if (a.radius() < b.radius()) return is_near_core(a, b, boundary);
  const ConvexHull core_of_b = world_hull(b);
  if (core_of_b.dimension() == 3) return is_behind_facets(world_hull(a), a.radius(), core_of_b, b.radius(), boundary);
  return a.radius() == b.radius() && is_near_core(a, b, boundary);
}

}  // namespace

bool has_interior(const PosedConvex& shape) {
  if (shape.radius() > 0) return true;
  if (shape.vertex_count() < 4) return false;
  // Of a box the corners 0, 1, 2 and 4; of a hull any four, which nearly always are enough.
  const Vec3 a = shape.vertex(0), b = shape.vertex(1), c = shape.vertex(2), d = shape.vertex(shape.vertex_count() / 2);
  const Filtered volume = filtered_orient3d(a, b, c, d);
  return volume.is_positive() || volume.is_negative() || world_hull(shape).dimension() == 3;
}

bool is_subset(const PosedConvex& a, const PosedConvex& b) { return is_within(a, b, Boundary::allowed); }

bool is_in_interior(const PosedConvex& a, const PosedConvex& b) { return is_within(a, b, Boundary::excluded); }

}  // namespace toccata
