#pragma once

#include "narrow/convex/vertices_of.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/quadrics.hpp"

// The points that stand out of a shape, in the world, rounded: where whole numbers put it, they are whole.
namespace toccata {

/// An inner point, or one of the shape where it has none; rounded.
inline Vec3 middle_of(const PosedQuadric& shape) { return shape.pose().offset; }

/// Calls visit(point): of a quadric the middle, the ends of the half axes, and those of its caps.
template <class Visit>
void visit_places(const PosedQuadric& shape, const Visit& visit) {
  const Mat3& linear = shape.pose().linear;
  const Vec3 &half = shape.half(), &middle = shape.pose().offset;
  const Vec3 x = half.x * linear.column(0), y = half.y * linear.column(1), z = half.z * linear.column(2);
  const auto visit_around = [&](const Vec3& centre) {
    visit(centre);
    for (const Vec3& along : {x, y}) {
      visit(centre - along);
      visit(centre + along);
    }
  };
  visit_around(middle);
  visit(middle - z);
  visit(middle + z);
  with_kind(shape.kind(), [&](auto kind) { kind.visit_places(middle, {x, y, z}, visit, visit_around); });
}

/// For a polytope, shows the vertices, and the points beside them at the radius.
template <class Visit>
void visit_places(const PosedPolytope& shape, const Visit& visit) {
  for (Index i = 0; i < shape.vertex_count(); ++i) {
    const Vec3 vertex = shape.vertex(i);
    visit(vertex);
    if (!(shape.radius() > 0)) continue;
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        Vec3 beside = vertex;
        beside[axis] += sign * shape.radius();
        visit(beside);
      }
  }
}

}  // namespace toccata
