#include "query/contacts/depth_cell.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/meshes/world_search.hpp"
#include "query/relation/relation_locality.hpp"

namespace toccata {
namespace {

/// A convex polygon, as what is cut off grows it by a corner at most.
struct ShaftPolygon {
  std::array<Vec3, 8> corners{};
  std::size_t count = 0;

  /// Keeps what of it has sign · coordinate at most the limit.
  void cut(int axis, double sign, double limit) {
    ShaftPolygon kept;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 &p = corners[i], &q = corners[(i + 1) % count];
      const double over_p = sign * p[axis] - limit, over_q = sign * q[axis] - limit;
      if (!(over_p > 0)) kept.corners[kept.count++] = p;
      if ((over_p > 0) != (over_q > 0)) kept.corners[kept.count++] = p + (over_p / (over_p - over_q)) * (q - p);
    }
    *this = kept;
  }
};

/// The box around a cell in a frame whose first axis is upwards, without an end above.
struct Shaft {
  CellFrame frame;
  Aabb range;  ///< of the cell in it

  [[nodiscard]] RegionRanges up_to(double height) const {
    RegionRanges shaft;
    shaft.count = 3;
    Aabb box;
    for (int i = 0; i < 8; ++i)
      box = merge(box,
                  frame.in_world({(i & 1) != 0 ? range.lower.x : height, (i & 2) != 0 ? range.lower.y : range.upper.y,
                                  (i & 4) != 0 ? range.lower.z : range.upper.z}));
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3& direction = frame.axes[static_cast<std::size_t>(axis)];
      const double origin = dot(direction, frame.origin);
      shaft.ranges[static_cast<std::size_t>(axis)] = {
          direction, {origin + range.lower[axis], origin + (axis == 0 ? height : range.upper[axis])}};
      shaft.reach[axis] = std::max(std::abs(box.lower[axis]), std::abs(box.upper[axis]));
    }
    return shaft;
  }
};

Shaft shaft_over(const DepthCell& cell, const Vec3& upwards, double slack) {
  Shaft shaft{frame_along(upwards, cell.middle), {}};
  for (const Vec3& corner : cell.corners)
    shaft.range = merge(shaft.range, Vec3{dot(shaft.frame.axes[0], corner), dot(shaft.frame.axes[1], corner),
                                          dot(shaft.frame.axes[2], corner)});
  const Vec3 more{slack, slack, slack};
  shaft.range = {shaft.range.lower - more, shaft.range.upper + more};
  return shaft;
}

/// The greatest difference of the triangle's normal, or of its opposite, from the direction along each axis.
Vec3 difference_along(const std::array<Vec3, 3>& axes, const Triangle& t, const Vec3& direction) {
  const Vec3 normal = unit_or_zero(cross(t[1] - t[0], t[2] - t[0]));
  const Vec3 difference = (dot(normal, direction) < 0 ? -normal : normal) - direction;
  return magnitudes({dot(axes[0], difference), dot(axes[1], difference), dot(axes[2], difference)});
}

/// The highest point of the surface in the shaft. None where the surface comes through that height, or what lies
/// between is not outside.
std::optional<double> highest_below(double limit, const Shaft& shaft, const DepthCell& cell, const PosedMesh& mesh,
                                    double slack, DistanceBounds& bounds) {
  double highest = shaft.range.lower.x;
  bool goes_through = false;
  visit_triangles_in(mesh, shaft.up_to(limit), [&](Index number) {
    bounds.triangles += 1;
    const Triangle t = mesh.triangle(number);
    ShaftPolygon part{{shaft.frame.inside(t[0]), shaft.frame.inside(t[1]), shaft.frame.inside(t[2])}, 3};
    if (std::max({part.corners[0].x, part.corners[1].x, part.corners[2].x}) <= highest) return true;
    for (const int axis : {1, 2}) {
      part.cut(axis, 1, shaft.range.upper[axis]);
      part.cut(axis, -1, -shaft.range.lower[axis]);
    }
    part.cut(0, -1, -highest);
    if (part.count == 0) return true;
    const Vec3 more = difference_along(cell.axes, t, shaft.frame.axes[0]);
    for (int axis = 0; axis < 3; ++axis) bounds.bend[axis] = std::max(bounds.bend[axis], more[axis]);
    for (std::size_t i = 0; i < part.count; ++i) {
      highest = std::max(highest, part.corners[i].x);
      goes_through = goes_through || part.corners[i].x > limit;
    }
    return !goes_through;
  });
  if (goes_through || highest + 4 * slack >= limit) return {};
  const Vec3 above = shaft.frame.in_world({highest + (limit - highest) / 2, 0, 0});
  if (is_interior(above, mesh)) return {};
  return highest;
}

}  // namespace

CellFrame frame_along(const Vec3& direction, const Vec3& origin) {
  const Vec3 size = magnitudes(direction);
  Vec3 other;
  other[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
  const Vec3 side = plain_unit_or_zero(cross(direction, other));
  return {origin, {direction, side, cross(direction, side)}};
}

DistanceBounds bounds_by_distance(const DepthSide& solid, const DepthSide::Place& middle, const DepthCell& cell,
                                  double slack) {
  DistanceBounds bounds;
  const double radius = cell.radius + slack;
  if (!middle.inside && middle.surface.lower > radius) return bounds;
  bounds.count = 1;
  const Vec3 to_surface = middle.surface.point - cell.middle;
  // From inside, the way back to a middle that is outside crosses the surface.
  if (!middle.inside)
    bounds.at_corners[0].fill(radius - middle.surface.lower);
  else
    for (std::size_t i = 0; i < 8; ++i)
      bounds.at_corners[0][i] = plain_length(cell.corners[i] - to_surface) + slacks_of_nearest * slack;
  constexpr double least_share = 0x1p-20;
  if (middle.surface.upper <= least_share * cell.radius)
    bounds.outwards = solid.outward_normal(middle.surface.element);
  else
    bounds.outwards = plain_unit_or_zero(middle.inside ? to_surface : -to_surface);
  return bounds;
}

void add_bound_by_height(const DepthSide& solid, const DepthSide::Place& middle, const DepthCell& cell,
                         const Vec3& upwards, double slack, DistanceBounds& bounds) {
  if (bounds.count == 0 || upwards == Vec3{}) return;
  const Shaft shaft = shaft_over(cell, upwards, slack);
  const double of_nearest = middle.inside ? middle.surface.upper : -middle.surface.lower;
  const double limit = std::max(shaft.range.upper.x, of_nearest) + cell.radius / 2 + 16 * slack;
  const std::optional<double> highest = highest_below(limit, shaft, cell, solid.mesh(), slack, bounds);
  if (!highest) return;
  if (*highest == shaft.range.lower.x) {  // nothing is above its lowest corner, and no point of it inside
    bounds.count = 0;
    return;
  }
  for (std::size_t i = 0; i < 8; ++i)
    bounds.at_corners[bounds.count][i] = *highest - dot(upwards, cell.corners[i]) + slack;
  bounds.count += 1;
}

double greatest_sum(const DistanceBounds& a, const DistanceBounds& b) {
  double least = a.count == 0 || b.count == 0 ? 0 : infinity;
  for (std::size_t i = 0; i < a.count; ++i)
    for (std::size_t j = 0; j < b.count; ++j) {
      double greatest = 0;
      for (std::size_t k = 0; k < 8; ++k) greatest = std::max(greatest, a.at_corners[i][k] + b.at_corners[j][k]);
      least = std::min(least, greatest);
    }
  return least;
}

}  // namespace toccata
