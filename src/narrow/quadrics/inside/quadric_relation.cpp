#include "narrow/quadrics/distance/quadric_nearest.hpp"
#include "narrow/quadrics/inside/quadric_containment.hpp"
#include "narrow/quadrics/quadric_order.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

/// The relation of two that overlap, with the containment that is proved, if one is; else the status says whether it is
/// open.
Relation with_containment(Relation relation, Within a_in_b, Within b_in_a) {
  if (a_in_b == Within::yes || b_in_a == Within::yes) {
    relation.containment = a_in_b == b_in_a        ? Containment::equal
                           : a_in_b == Within::yes ? Containment::a_in_b
                                                   : Containment::b_in_a;
    return relation;
  }
  if (a_in_b == Within::undecided || b_in_a == Within::undecided)
    relation.status = Status::undecided;
  else if (a_in_b == Within::unfinished || b_in_a == Within::unfinished)
    relation.status = Status::not_converged;
  return relation;
}

bool may_hold(const Relation& found) {
  return found.kind == RelationKind::overlapping || found.kind == RelationKind::crossing;
}

Relation relation_of(const QuadricNearest& found, bool b_solid) {
  Relation result;
  result.a_solid = true;
  result.b_solid = b_solid;
  if (found.contact == QuadricContact::apart) return result;
  if (found.contact == QuadricContact::undecided || found.shared) {
    result.kind = RelationKind::touching;
    result.status = is_touching(found) ? Status::exact : Status::undecided;
    return result;
  }
  result.kind = b_solid ? RelationKind::overlapping : RelationKind::crossing;
  return result;
}

}  // namespace

Relation relation(const PosedQuadric& a, const PosedQuadric& b) {
  if (comes_before(b, a)) return flipped(relation(b, a));
  const PairFrame frame = pair_frame(a, b);
  const QuadricBody body_a(a, frame), body_b(b, frame);
  const Relation found = relation_of(nearest_of(a, body_a, b, body_b, QuadricQuestion::meeting), true);
  if (!may_hold(found)) return found;
  if (a == b) return with_containment(found, Within::yes, Within::yes);
  return with_containment(found, is_held_by_quadric_body(body_a, body_b), is_held_by_quadric_body(body_b, body_a));
}

Relation relation(const PosedQuadric& a, const PosedPolytope& b) {
  const PairFrame frame = pair_frame(a, b);
  const QuadricBody body_a(a, frame), body_b(b, frame);
  const Relation found = relation_of(nearest_of(a, body_a, b, body_b, QuadricQuestion::meeting), b.solid());
  if (!may_hold(found)) return found;
  const Within b_in_a = is_held_by_quadric_body(b, body_b, a, body_a);
  const bool is_all = b_in_a == Within::yes || !b.solid();
  return with_containment(found, is_all ? Within::no : is_held_by_convex(body_a, b, body_b, frame), b_in_a);
}

Relation relation(const PosedPolytope& a, const PosedQuadric& b) { return flipped(relation(b, a)); }

}  // namespace toccata
