#include "toccata/reports/report.hpp"

namespace toccata {

std::string name_of(RelationKind kind) {
  switch (kind) {
    case RelationKind::apart:
      return "apart";
    case RelationKind::touching:
      return "touching";
    case RelationKind::overlapping:
      return "overlapping";
    case RelationKind::crossing:
      return "crossing";
  }
  return {};
}

std::string name_of(Containment containment) {
  switch (containment) {
    case Containment::none:
      return "none";
    case Containment::a_in_b:
      return "a_in_b";
    case Containment::b_in_a:
      return "b_in_a";
    case Containment::equal:
      return "equal";
  }
  return {};
}

std::string name_of(IntersectionKind kind) {
  switch (kind) {
    case IntersectionKind::none:
      return "none";
    case IntersectionKind::point:
      return "point";
    case IntersectionKind::segment:
      return "segment";
    case IntersectionKind::polygon:
      return "polygon";
  }
  return {};
}

std::string name_of(DepthEnd end) {
  switch (end) {
    case DepthEnd::precise:
      return "precise";
    case DepthEnd::exhausted:
      return "exhausted";
    case DepthEnd::out_of_time:
      return "out of time";
  }
  return {};
}

std::string name_of(Status status) {
  switch (status) {
    case Status::exact:
      return "exact";
    case Status::undecided:
      return "undecided";
    case Status::not_converged:
      return "not_converged";
  }
  return {};
}

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
