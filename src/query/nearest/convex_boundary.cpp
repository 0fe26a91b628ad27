#include "query/nearest/convex_boundary.hpp"

#include <cmath>

#include "math/constants.hpp"
#include "math/expansion.hpp"
#include "math/wide_integer.hpp"
#include "narrow/convex/rounded_depth.hpp"
#include "narrow/exact/exact_nearest.hpp"
#include "query/nearest/surface_target.hpp"
#include "query/relation/hull_mesh.hpp"

namespace toccata {
namespace {

SurfacePoint surface_point(double upper, const Vec3& point, Status status) {
  return {lower_from(upper), upper, point, 0, 0, status};
}

/// `lower` is the exact depth or the double before it; `upper` is more than the next where that is along a direction
/// that was rounded.
double upper_of(const Penetration& depth) {
  const bool is_exact = depth.upper == depth.lower;
  return is_exact ? depth.upper : std::nextafter(depth.lower, infinity);
}

Vec3 rounded_unit(const IntegerVector& v) {
  const Vec3 rounded = rounded_direction(v);
  return (1 / std::sqrt(dot(rounded, rounded))) * rounded;
}

/// Across two vectors, whose coordinates may be of any size; zero where they are parallel.
IntegerVector exact_cross(const Triangle& t) {
  const int exponent = common_exponent(t.vertex);
  const IntegerVector first = scaled_wide(t[0], exponent);
  return cross(scaled_wide(t[1], exponent) - first, scaled_wide(t[2], exponent) - first);
}

/// Across the longest way between the corners of a triangle without area; any direction for a point.
Vec3 across_line(const Triangle& t) {
  const int exponent = common_exponent(t.vertex);
  for (const int corner : {1, 2}) {
    const IntegerVector along = scaled_wide(t[corner], exponent) - scaled_wide(t[0], exponent);
    if (is_zero(along)) continue;
    const Vec3 rounded = rounded_direction(along);
    std::size_t least = 0;
    for (const std::size_t axis : {1U, 2U})
      if (std::fabs(rounded[static_cast<int>(axis)]) < std::fabs(rounded[static_cast<int>(least)])) least = axis;
    IntegerVector other{};
    other[least] = 1;
    return rounded_unit(cross(along, other));
  }
  return {1, 0, 0};
}

}  // namespace

/// The surface of the hull of the world vertices.
struct ConvexBoundary::Core {
  explicit Core(const HullMesh& hull)
      : dimension(hull.dimension), model(hull.mesh), mesh(model, {}), target(mesh, 0, 0, 1) {}

  int dimension;
  Model model;
  PosedMesh mesh;
  SurfaceTarget target;
};

const ConvexBoundary::Core& ConvexBoundary::core() const {
  std::call_once(once_, [&] { core_ = std::make_shared<const Core>(hull_mesh(shape_)); });
  return *core_;
}

SurfacePoint ConvexBoundary::nearest(const Vec3& point, SearchScratch& scratch) const {
  const Distance outside = distance(PosedPolytope(Point{point}), shape_);
  if (outside.upper > 0 || !shape_.solid()) return surface_point(outside.upper, outside.on_b, outside.status);
  return shape_.radius() > 0 ? from_within(point, scratch) : from_core(point, scratch);
}

/// The nearest point of the boundary to a point of the hull of the world vertices.
SurfacePoint ConvexBoundary::from_core(const Vec3& point, SearchScratch& scratch) const {
  NearestElements nearest(1, infinity, scratch.inner_points);
  core().target.see_near(point, nearest, scratch);
  return nearest.in_order().front();
}

/// The same for a shape with a radius, whose distance is what that leaves of the way from the core, or, from within the
/// core, the way out of it and the radius.
SurfacePoint ConvexBoundary::from_within(const Vec3& point, SearchScratch& scratch) const {
  const PosedPolytope from(Point{point});
  const double radius = shape_.radius();
  const ExactNearest way = exact_nearest(from, shape_, first_vertices());
  if (!way.meet) {
    const Penetration depth = rounded_depth(way, 0, radius, {});
    return surface_point(upper_of(depth), depth.on_b, depth.status);
  }
  if (core().dimension < 3) {
    const Triangle all = core().mesh.triangle(0);
    const IntegerVector normal = exact_cross(all);
    return surface_point(radius, point + radius * (is_zero(normal) ? across_line(all) : rounded_unit(normal)),
                         Status::exact);
  }
  const SurfacePoint out = from_core(point, scratch);
  const Vec3 normal = rounded_unit(exact_cross(core().mesh.triangle(out.element)));
  // A double more would leave the interval's lower end too high where all are among the least doubles.
  return surface_point(sum_not_less(out.upper, radius), out.point + radius * normal, out.status);
}

SurfacePoint nearest_of_boundary(const Vec3& point, const PosedHalfSpace& shape) {
  const PosedPolytope from(Point{point});
  Distance found = distance(from, shape);
  if (found.upper == 0) {
    PosedHalfSpace rest = shape;
    rest.normal = -rest.normal;
    found = distance(from, rest);
  }
  return surface_point(found.upper, found.on_b, found.status);
}

}  // namespace toccata
