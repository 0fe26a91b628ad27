#include "toccata/io/report.hpp"

namespace toccata {

std::string verb_of(const Relation& relation) {
  switch (relation.containment) {
    case Containment::a_in_b:
      return "lies inside";
    case Containment::b_in_a:
      return "contains";
    case Containment::equal:
      return "equals";
    case Containment::none:
      break;
  }
  switch (relation.kind) {
    case RelationKind::apart:
      return "is apart from";
    case RelationKind::touching:
      return "touches";
    case RelationKind::overlapping:
      return "overlaps";
    case RelationKind::crossing:
      return "intersects";
  }
  return {};
}

std::string remark_on(const Relation& relation) {
  if (relation.side_unresolved)
    return "(both surfaces; no two faces cross, so the faces cannot tell whether they pass through)";
  if (relation.kind == RelationKind::touching && relation.status == Status::undecided)
    return "(undecided: within 10⁻¹² of their size of touching)";
  if (relation.a_solid && relation.b_solid) return "(both solids)";
  if (!relation.a_solid && !relation.b_solid) return "(both surfaces)";
  return relation.a_solid ? "(a solid, a surface)" : "(a surface, a solid)";
}

}  // namespace toccata
