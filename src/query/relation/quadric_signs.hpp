#pragma once

#include <cstdint>

#include "toccata/narrow/quadrics.hpp"

// What is known of a triangle or a point and a shape: of all shapes but quadrics everything.
namespace toccata {

enum class Known : std::uint8_t { no, yes, undecided };

constexpr Known known(bool is_so) { return is_so ? Known::yes : Known::no; }

constexpr Known both(Known a, Known b) {
  if (a == Known::no || b == Known::no) return Known::no;
  return a == Known::yes && b == Known::yes ? Known::yes : Known::undecided;
}

/// Whether the shape holds a world point.
template <class Shape>
Known holds_point(const Shape& shape, const Vec3& point) {
  return known(overlap(PosedPolytope(Point(point)), shape));
}
inline Known holds_point(const PosedQuadric& shape, const Vec3& point) {
  const QuadricContact found = quadric_contact(shape, PosedPolytope(Point(point)));
  if (found == QuadricContact::undecided) return Known::undecided;
  return known(found == QuadricContact::contact);
}

/// Whether a triangle reaches into the interior of a solid shape.
template <class Shape>
Known reaches_into(const PosedPolytope& triangle, const Shape& shape) {
  const Relation found = relation(triangle, shape);
  if (found.kind == RelationKind::touching && found.status == Status::undecided) return Known::undecided;
  return known(found.kind == RelationKind::crossing);
}

/// Whether the shape contains a triangle, of which `found` is the relation to it.
template <class Shape>
Known lies_within(const PosedPolytope&, const Relation& found, const Shape&) {
  return known(found.containment == Containment::a_in_b);
}
inline Known lies_within(const PosedPolytope& triangle, const Relation& found, const PosedQuadric& shape) {
  if (found.kind == RelationKind::apart) return Known::no;
  if (found.containment == Containment::a_in_b) return Known::yes;
  Known all = Known::yes;
  for (Index i = 0; i < triangle.vertex_count() && all != Known::no; ++i)
    all = both(all, holds_point(shape, triangle.vertex(i)));
  return all;
}

}  // namespace toccata
