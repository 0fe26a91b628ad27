#include "toccata/bounds/volume.hpp"

#include <array>

#include "toccata/math/predicates.hpp"

namespace toccata {
namespace {

/// The corner of the rectangle that reaches farthest to the left of the direction from a to b.
Vec2 leftmost(const Vec2& lower, const Vec2& upper, const Vec2& a, const Vec2& b) {
  return {b.y > a.y ? lower.x : upper.x, b.x > a.x ? upper.y : lower.y};
}

/// The line through a and b, an edge of the triangle whose third corner is c, has the rectangle strictly on one side
/// and the triangle on the other, or on itself.
bool line_parts(const Vec2& lower, const Vec2& upper, const Vec2& a, const Vec2& b, const Vec2& c) {
  const Sign triangle = orient2d(a, b, c);
  return (triangle != Sign::positive && orient2d(a, b, leftmost(lower, upper, b, a)) == Sign::positive) ||
         (triangle != Sign::negative && orient2d(a, b, leftmost(lower, upper, a, b)) == Sign::negative);
}

/// Seen along the axis.
bool shadows_part(const Aabb& box, const Triangle& t, int axis) {
  const Vec2 lower = drop_axis(box.lower, axis), upper = drop_axis(box.upper, axis);
  const std::array corner{drop_axis(t[0], axis), drop_axis(t[1], axis), drop_axis(t[2], axis)};
  return line_parts(lower, upper, corner[0], corner[1], corner[2]) ||
         line_parts(lower, upper, corner[1], corner[2], corner[0]) ||
         line_parts(lower, upper, corner[2], corner[0], corner[1]);
}

/// All corners of the box are strictly on one side of the triangle's plane.
bool plane_parts(const Aabb& box, const Triangle& t) {
  Vec3 highest, lowest;
  for (int axis = 0; axis < 3; ++axis) {
    const Sign normal = orient2d(drop_axis(t[0], axis), drop_axis(t[1], axis), drop_axis(t[2], axis));
    highest[axis] = normal == Sign::negative ? box.lower[axis] : box.upper[axis];
    lowest[axis] = normal == Sign::negative ? box.upper[axis] : box.lower[axis];
  }
  return orient3d(t[0], t[1], t[2], highest) == Sign::negative || orient3d(t[0], t[1], t[2], lowest) == Sign::positive;
}

}  // namespace

bool overlap(const Aabb& box, const Triangle& t) {
  if (is_empty(box) || !overlap(box, fit_aabb(t.vertex))) return false;
  for (const Vec3& vertex : t.vertex)
    if (contains(box, {vertex, vertex})) return true;
  return !shadows_part(box, t, 0) && !shadows_part(box, t, 1) && !shadows_part(box, t, 2) && !plane_parts(box, t);
}

}  // namespace toccata
