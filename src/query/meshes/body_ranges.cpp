#include "query/meshes/body_ranges.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// How much less surface than that of its box the directions have to leave a body for them to be worth their tests.
constexpr double worthwhile_share = 0.5;

using Directions = std::array<Vec3, 3>;

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

/// Of what leads from a point to a vertex the longest part that is at right angles to a direction.
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
Directions directions_of_vertices(const PosedPolytope& body) {
  const Vec3 end = farthest_from(body.vertex(0), body), other = farthest_from(end, body);
  const Vec3 along = unit_or_zero(other - end);
  Vec3 across = unit_or_zero(longest_across(along, end, body));
  if (across == Vec3{}) across = some_normal_of(along);
  return {along, across, unit_or_zero(cross(along, across))};
}

Directions directions_of_columns(const Mat3& linear) {
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
std::array<BodyRange, 3> ranges_along(const Directions& directions, const Body& body) {
  std::array<BodyRange, 3> ranges;
  for (std::size_t i = 0; i < 3; ++i) ranges[i] = {directions[i], range_along(directions[i], body)};
  return ranges;
}

}  // namespace

BodyRanges::BodyRanges(const PosedPolytope& body, const Aabb& box) {
  if (body.vertex_count() < 2) return;
  reach_ = largest_coordinates(box);
  const bool is_box = std::isfinite(body.as_box().slack);
  ranges_ = ranges_along(is_box ? directions_of_columns(body.pose().linear) : directions_of_vertices(body), body);
  keep_if_narrower_than(box);
}

BodyRanges::BodyRanges(const PosedQuadric& body, const Aabb& box)
    : ranges_(ranges_along(directions_of_columns(body.pose().linear), body)),
      reach_(world_sizes(body.pose(), {-body.half(), body.half()})) {
  keep_if_narrower_than(box);
}

void BodyRanges::keep_if_narrower_than(const Aabb& box) {
  const Aabb own{{ranges_[0].range.low, ranges_[1].range.low, ranges_[2].range.low},
                 {ranges_[0].range.high, ranges_[1].range.high, ranges_[2].range.high}};
  if (half_area(own) < worthwhile_share * half_area(box)) count_ = 3;
}

}  // namespace toccata
