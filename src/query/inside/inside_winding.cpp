#include "query/inside/inside_winding.hpp"

#include "math/constants.hpp"
#include "query/meshes/world_search.hpp"

namespace toccata {
namespace {

/// On which side of a → b the point lies once it is moved by (ε, ε²): the sign of the first of
/// (b − a) × (p − a), (b − a) × (1, 0), (b − a) × (0, 1) that is not 0. Zero only for a = b.
Sign perturbed_side(const Vec3& a, const Vec3& b, const ExactPoint& p, int axis) {
  const Sign side = orient2d(a, b, p, axis);
  if (side != Sign::zero) return side;
  const Vec2 a2 = drop_axis(a, axis), b2 = drop_axis(b, axis);
  if (a2.y != b2.y) return a2.y > b2.y ? Sign::positive : Sign::negative;
  if (a2.x != b2.x) return b2.x > a2.x ? Sign::positive : Sign::negative;
  return Sign::zero;
}

/// The orientation of the projected triangle if the perturbed point lies in it, else zero; so also for a triangle whose
/// projection has no area, since its edges run in opposite directions along one line.
Sign perturbed_cover(const Triangle& t, const ExactPoint& p, int axis) {
  const Sign first = perturbed_side(t[0], t[1], p, axis);
  if (first == Sign::zero) return Sign::zero;
  for (int i = 1; i < 3; ++i)
    if (perturbed_side(t[i], t[(i + 1) % 3], p, axis) != first) return Sign::zero;
  return first;
}

bool are_coplanar(const Triangle& plane, const Triangle& t) {
  for (const Vec3& vertex : t.vertex)
    if (orient3d(plane[0], plane[1], plane[2], vertex) != Sign::zero) return false;
  return true;
}

Aabb region_ahead(const ExactPoint& p, int axis) {
  Aabb region = p.box();
  region.upper[axis] = infinity;
  return region;
}

LineWinding wind(const PosedMesh& mesh, const ExactPoint& p, int axis, const Triangle* plane) {
  LineWinding result;
  int through = 0;
  visit_triangles_near(mesh, region_ahead(p, axis), [&](Index number) {
    const Triangle t = mesh.triangle(number);
    const Sign orientation = perturbed_cover(t, p, axis);
    if (orientation != Sign::zero) {
      // Beyond p is the side to which the triangle's normal does not point, if that points along the axis.
      const Sign above = orient3d(t, p) * orientation;
      if (above == Sign::negative) result.ahead += static_cast<int>(orientation);
      if (above == Sign::zero) through += static_cast<int>(orientation);
    }
    if (lies_on(p, t)) {
      result.on_face = true;
      result.on_sheet |= has_area(t);
      result.on_another_plane |= plane != nullptr && has_area(t) && !are_coplanar(*plane, t);
    }
    return true;
  });
  result.behind = result.ahead + through;
  return result;
}

}  // namespace

LineWinding wind_along(const PosedMesh& mesh, const ExactPoint& p, int axis, const Triangle& plane) {
  return wind(mesh, p, axis, &plane);
}

LineWinding wind_along(const PosedMesh& mesh, const ExactPoint& p, int axis) { return wind(mesh, p, axis, nullptr); }

}  // namespace toccata
