#include "narrow/convex_containment.hpp"
#include "narrow/exact_distance.hpp"
#include "narrow/exact_interior.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

VertexPairs known_simplex(const ConvexWorkspace& workspace) {
  VertexPairs pairs;
  for (std::size_t i = 0; i < static_cast<std::size_t>(workspace.simplex_size); ++i)
    pairs.append(workspace.vertex_a[i], workspace.vertex_b[i]);
  return pairs;
}

/// A solid whose interior is looked for must have one: a pose may have flattened it by rounding.
bool may_be_entered(const PosedConvex& shape) { return !shape.solid() || has_interior(shape); }

/// Of two solids the interiors meet; of a solid and a surface, the surface meets the interior; of two surfaces the
/// relative interiors meet, and they do not lie in one plane. With radii that is: the cores are nearer than their sum.
bool meet_deeply(const PosedConvex& a, const PosedConvex& b, const VertexPairs& hint) {
  if (!may_be_entered(a) || !may_be_entered(b)) return false;
  if (a.radius() == 0 && b.radius() == 0) return interiors_meet(a, b, hint);
  VertexPairs start = hint;
  if (start.size == 0) start.append(0, 0);
  return compare_core_distance(exact_nearest(a, b, start), a.radius(), b.radius()) == Sign::negative;
}

Containment containment_of_solids(const PosedConvex& a, const PosedConvex& b) {
  const bool a_in_b = is_subset(a, b), b_in_a = is_subset(b, a);
  if (a_in_b && b_in_a) return Containment::equal;
  if (a_in_b) return Containment::a_in_b;
  return b_in_a ? Containment::b_in_a : Containment::none;
}

Relation relation_when_deep(const PosedConvex& a, const PosedConvex& b) {
  if (a.solid() && b.solid()) return {RelationKind::overlapping, containment_of_solids(a, b)};
  if (a.solid()) return {RelationKind::crossing, is_in_interior(b, a) ? Containment::b_in_a : Containment::none};
  if (b.solid()) return {RelationKind::crossing, is_in_interior(a, b) ? Containment::a_in_b : Containment::none};
  return {RelationKind::crossing};
}

Relation kind_of(const PosedConvex& a, const PosedConvex& b, ConvexWorkspace& workspace) {
  if (!overlap(a, b, &workspace)) return {};
  if (meet_deeply(a, b, known_simplex(workspace))) return relation_when_deep(a, b);
  return {RelationKind::touching, Containment::none, !a.solid() && !b.solid()};
}

}  // namespace

Relation relation(const PosedConvex& a, const PosedConvex& b, ConvexWorkspace* workspace) {
  ConvexWorkspace own;
  Relation answer = kind_of(a, b, workspace != nullptr ? *workspace : own);
  answer.a_solid = a.solid();
  answer.b_solid = b.solid();
  return answer;
}

}  // namespace toccata
