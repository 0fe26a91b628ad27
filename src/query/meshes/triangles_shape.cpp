#include "query/meshes/triangles_shape.hpp"

#include <algorithm>

#include "query/meshes/world_search.hpp"
#include "query/relation/hull_mesh.hpp"
#include "query/relation/quadric_signs.hpp"
#include "query/relation/relation_convex.hpp"
#include "query/relation/relation_locality.hpp"

namespace toccata {
namespace {

/// Calls `see(number, the triangle as a convex shape)` for all triangles that may meet the shape, until it returns
/// false.
template <class Bounded, class See>
void visit_near(const PosedMesh& mesh, const Bounded& shape, const See& see) {
  const Aabb box = world_box(shape);
  visit_triangles_near(mesh, box, ranges_of(shape, box),
                       [&](Index i) { return see(i, PosedPolytope(mesh.triangle(i))); });
}

template <class See>
void visit_near(const PosedMesh& mesh, const PosedHalfSpace& shape, const See& see) {
  visit_triangles_near(mesh, shape, [&](Index i) { return see(i, PosedPolytope(mesh.triangle(i))); });
}

template <class Shape>
std::optional<Index> first_that_meets(const PosedMesh& mesh, const Shape& shape) {
  std::optional<Index> met;
  visit_near(mesh, shape, [&](Index i, const PosedPolytope& triangle) {
    if (overlap(triangle, shape)) met = i;
    return !met;
  });
  return met;
}

template <class Shape>
bool some_triangle_meets(const PosedMesh& mesh, const Shape& shape) {
  return first_that_meets(mesh, shape).has_value();
}

/// Ascending; they lie in `found`.
template <class Shape>
std::span<const Index> all_that_meet(const PosedMesh& mesh, const Shape& shape, std::vector<Index>& found) {
  found.clear();
  visit_near(mesh, shape, [&](Index i, const PosedPolytope& triangle) {
    if (overlap(triangle, shape)) found.push_back(i);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

/// The relation of a mesh taken as surface: what its triangles say.
template <class Shape>
Relation relation_by_triangles(const PosedMesh& mesh, const Shape& shape) {
  Relation result;
  Index seen = 0;
  Known all_inside = Known::yes;
  visit_near(mesh, shape, [&](Index, const PosedPolytope& triangle) {
    const Relation found = relation(triangle, shape);
    if (found.kind == RelationKind::crossing) result.kind = RelationKind::crossing;
    if (found.kind == RelationKind::touching && result.kind == RelationKind::apart) {
      result.kind = found.kind;
      result.status = found.status;
    }
    if (all_inside != Known::no) all_inside = both(all_inside, lies_within(triangle, found, shape));
    ++seen;
    return all_inside != Known::no || result.kind != RelationKind::crossing;
  });
  if (result.kind == RelationKind::crossing) result.status = Status::exact;
  if (seen != mesh.model().mesh().triangle_count() || result.kind == RelationKind::apart) return result;
  if (all_inside == Known::yes) result.containment = Containment::a_in_b;
  if (all_inside == Known::undecided) result.status = Status::undecided;
  return result;
}

/// A convex shape that none of the solid's triangles meets, so that it lies inside as a whole or outside.
Relation relation_off_the_faces(const PosedMesh& solid, const PosedPolytope& shape) {
  Relation result;
  if (!is_interior(shape.vertex(0), solid)) return result;
  const bool has_interior = shape.radius() > 0 || (shape.solid() && hull_mesh(shape).dimension == 3);
  result.kind = has_interior    ? RelationKind::overlapping
                : shape.solid() ? RelationKind::touching
                                : RelationKind::crossing;
  if (result.kind != RelationKind::touching) result.containment = Containment::b_in_a;
  return result;
}

Relation relation_of_solid(const PosedMesh& solid, const PosedPolytope& shape) {
  std::vector<Index> memory;
  const auto contacts = all_that_meet(solid, shape, memory);
  if (contacts.empty()) return relation_off_the_faces(solid, shape);
  return shape.radius() > 0 ? relation_of_solid_and_round(solid, shape, contacts)
                            : relation_of_solid_and_polytope(solid, shape);
}

Relation relation_of_solid(const PosedMesh& solid, const PosedHalfSpace& shape) {
  std::vector<Index> memory;
  const auto contacts = all_that_meet(solid, shape, memory);
  return contacts.empty() ? Relation{} : relation_of_solid_and_round(solid, shape, contacts);
}

Relation relation_of_solid(const PosedMesh& solid, const PosedQuadric& shape) {
  std::vector<Index> memory;
  const auto contacts = all_that_meet(solid, shape, memory);
  if (!contacts.empty()) return relation_of_solid_and_round(solid, shape, contacts);
  if (!is_interior(some_point_of(shape), solid)) return {};
  return {.kind = RelationKind::overlapping, .containment = Containment::b_in_a};
}

template <class Shape>
Relation relation_as_taken(const PosedTriangles& a, const Shape& b, bool b_solid) {
  Relation result = a.solid ? relation_of_solid(a.mesh, b) : relation_by_triangles(a.mesh, b);
  result.a_solid = a.solid;
  result.b_solid = b_solid;
  result.side_unresolved = !a.solid && !b_solid && result.kind == RelationKind::touching;
  return result;
}

}  // namespace

bool overlap(const PosedTriangles& a, const PosedPolytope& b) {
  return some_triangle_meets(a.mesh, b) || (a.solid && is_interior(b.vertex(0), a.mesh));
}

bool overlap(const PosedTriangles& a, const PosedHalfSpace& b) { return some_triangle_meets(a.mesh, b); }

bool overlap(const PosedTriangles& a, const PosedQuadric& b) {
  return some_triangle_meets(a.mesh, b) || (a.solid && is_interior(some_point_of(b), a.mesh));
}

QuadricContact quadric_contact(const PosedTriangles& a, const PosedQuadric& b) {
  QuadricContact found = QuadricContact::apart;
  visit_near(a.mesh, b, [&](Index, const PosedPolytope& triangle) {
    const QuadricContact one = quadric_contact(triangle, b);
    if (one != QuadricContact::apart) found = one;
    return found != QuadricContact::contact;
  });
  const bool is_held = found != QuadricContact::contact && a.solid && is_interior(some_point_of(b), a.mesh);
  return is_held ? QuadricContact::contact : found;
}

std::optional<Index> some_triangle_meeting(const PosedMesh& a, const PosedPolytope& b) {
  return first_that_meets(a, b);
}
std::optional<Index> some_triangle_meeting(const PosedMesh& a, const PosedHalfSpace& b) {
  return first_that_meets(a, b);
}
std::optional<Index> some_triangle_meeting(const PosedMesh& a, const PosedQuadric& b) {
  std::optional<Index> proved, undecided;
  visit_near(a, b, [&](Index i, const PosedPolytope& triangle) {
    const QuadricContact found = quadric_contact(triangle, b);
    if (found == QuadricContact::contact) proved = i;
    if (found == QuadricContact::undecided && !undecided) undecided = i;
    return !proved;
  });
  return proved ? proved : undecided;
}

std::span<const Index> triangles_intersecting(const PosedMesh& a, const PosedPolytope& b, SearchScratch& scratch) {
  return all_that_meet(a, b, scratch.triangles);
}
std::span<const Index> triangles_intersecting(const PosedMesh& a, const PosedHalfSpace& b, SearchScratch& scratch) {
  return all_that_meet(a, b, scratch.triangles);
}
std::span<const Index> triangles_intersecting(const PosedMesh& a, const PosedQuadric& b, SearchScratch& scratch) {
  return all_that_meet(a, b, scratch.triangles);
}

Relation relation(const PosedTriangles& a, const PosedPolytope& b) { return relation_as_taken(a, b, b.solid()); }
Relation relation(const PosedTriangles& a, const PosedHalfSpace& b) { return relation_as_taken(a, b, true); }
Relation relation(const PosedTriangles& a, const PosedQuadric& b) { return relation_as_taken(a, b, true); }

}  // namespace toccata
