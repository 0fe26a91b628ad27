#include "query/meshes/body_ranges.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// How much less surface than that of its box the directions have to leave a body for them to be worth their tests.
constexpr double worthwhile_share = 0.5;

using BodyAxes = std::array<Vec3, 3>;

Vec3 farthest_from(const Vec3& point, const PosedPolytope& body) {
  Vec3 farthest = point;
  double greatest = 0;
  for (Index i = 0; i < body.vertex_count(); ++i) {
    const Vec3 vertex = body.vertex(i), way = vertex - point;
    if (!(dot(way, way) > greatest)) continue;
    greatest = dot(way, way);
    farthest = vertex;
  }
  return farthest;
}

/// The longest of the parts, at right angles to a direction, of the ways from a point to the vertices.
Vec3 longest_across(const Vec3& direction, const Vec3& point, const PosedPolytope& body) {
  Vec3 longest{};
  for (Index i = 0; i < body.vertex_count(); ++i) {
    const Vec3 way = body.vertex(i) - point;
    const Vec3 across = way - dot(way, direction) * direction;
    const bool is_rounding = dot(across, across) <= 0x1p-40 * dot(way, way);
    if (!is_rounding && dot(across, across) > dot(longest, longest)) longest = across;
  }
  return longest;
}

/// At right angles to it, whatever of these.
Vec3 some_normal_of(const Vec3& direction) {
  Vec3 axis{};
  const Vec3 sizes = magnitudes(direction);
  axis[sizes.x <= sizes.y && sizes.x <= sizes.z ? 0 : sizes.y <= sizes.z ? 1 : 2] = 1;
  return unit_or_zero(cross(direction, axis));
}

/// Along the longest way between two vertices, nearly; along what leads farthest away from it; and across both.
BodyAxes directions_of_vertices(const PosedPolytope& body) {
  const Vec3 end = farthest_from(body.vertex(0), body), other = farthest_from(end, body);
  const Vec3 along = unit_or_zero(other - end);
  Vec3 across = unit_or_zero(longest_across(along, end, body));
  if (across == Vec3{}) across = some_normal_of(along);
  return {along, across, unit_or_zero(cross(along, across))};
}

BodyAxes directions_of_columns(const Mat3& linear) {
  return {unit_or_zero(cross(linear.column(1), linear.column(2))),
          unit_or_zero(cross(linear.column(2), linear.column(0))),
          unit_or_zero(cross(linear.column(0), linear.column(1)))};
}

FormRange range_along(const Vec3& direction, const PosedPolytope& body) {
  FormRange range{infinity, -infinity};
  for (Index i = 0; i < body.vertex_count(); ++i) {
    const double height = dot(direction, body.vertex(i));
    range = {std::min(range.low, height), std::max(range.high, height)};
  }
  return {range.low - body.radius(), range.high + body.radius()};
}

/// That of the image of the box around the shape.
FormRange range_along(const Vec3& direction, const PosedQuadric& body) {
  const double middle = dot(direction, body.pose().offset);
  double half = 0;
  for (int j = 0; j < 3; ++j) half += std::abs(dot(direction, body.pose().linear.column(j))) * body.half()[j];
  return {middle - half, middle + half};
}

template <class Body>
RegionRanges ranges_along(const BodyAxes& directions, const Body& body, const Aabb& box, const Vec3& reach) {
  RegionRanges found{{}, 0, reach};
  Aabb own;  // in the frame of the directions
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    found.ranges[at] = {directions[at], range_along(directions[at], body)};
    own.lower[i] = found.ranges[at].range.low;
    own.upper[i] = found.ranges[at].range.high;
  }
  if (half_area(own) < worthwhile_share * half_area(box)) found.count = 3;
  return found;
}

}  // namespace

RegionRanges ranges_of(const PosedPolytope& body, const Aabb& box) {
  if (body.vertex_count() < 2) return {};
  const bool is_box = std::isfinite(body.as_box().slack);
  const BodyAxes directions = is_box ? directions_of_columns(body.pose().linear) : directions_of_vertices(body);
  return ranges_along(directions, body, box, largest_coordinates(box));
}

RegionRanges ranges_of(const PosedQuadric& body, const Aabb& box) {
  return ranges_along(directions_of_columns(body.pose().linear), body, box,
                      world_sizes(body.pose(), {-body.half(), body.half()}));
}

}  // namespace toccata
