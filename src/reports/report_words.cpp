#include <cmath>

#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

/// What is within its tolerance is no graver than what touches.
int gravity_of(RelationKind kind, bool within_tolerance) {
  if (kind == RelationKind::apart) return 0;
  return kind == RelationKind::touching || within_tolerance ? 1 : 2;
}

}  // namespace

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

Since since_baseline(const ReportedPair& pair) {
  if (!pair.was || (!pair.was->demanded && is_clash(pair))) return Since::added;
  // Without a tolerance of now the depth of then tells nothing: an overlap was one.
  const bool was_within = pair.was->within_tolerance && pair.tolerance != ToleranceVerdict::none;
  const int now = gravity_of(pair.relation.kind, pair.tolerance == ToleranceVerdict::within),
            then = gravity_of(pair.was->kind, was_within);
  if (now > then || pair.growth != ClashGrowth::none) return Since::graver;
  return pair.moved_by ? Since::moved : Since::known;
}

bool is_clash(const ReportedPair& pair) {
  const bool is_told_alone = pair.relation.kind == RelationKind::apart && std::isinf(pair.clearance);
  return pair.tolerance != ToleranceVerdict::within && !is_told_alone;
}

std::string name_of(ClashKind kind) {
  switch (kind) {
    case ClashKind::clearance:
      return "clearance";
    case ClashKind::touching:
      return "touching";
    case ClashKind::crossing:
      return "crossing";
    case ClashKind::overlap:
      return "overlap";
    case ClashKind::protrude:
      return "protrude";
    case ClashKind::pierce:
      return "pierce";
    case ClashKind::contains:
      return "contains";
    case ClashKind::equal:
      return "equal";
  }
  return {};
}

std::string name_of(ClashPiercing piercing) {
  switch (piercing) {
    case ClashPiercing::none:
      return "none";
    case ClashPiercing::unknown:
      return "unknown";
    case ClashPiercing::a_through_b:
      return "a_through_b";
    case ClashPiercing::b_through_a:
      return "b_through_a";
  }
  return {};
}

std::string tolerance_decided_by(const ReportedPair& pair) {
  if (pair.tolerance == ToleranceVerdict::none) return {};
  if (pair.local_depth) return "local_depth";
  return pair.penetration ? "penetration" : "";
}

std::string name_of(ToleranceVerdict verdict) {
  switch (verdict) {
    case ToleranceVerdict::none:
      return "none";
    case ToleranceVerdict::within:
      return "within";
    case ToleranceVerdict::beyond:
      return "beyond";
    case ToleranceVerdict::undecided:
      return "undecided";
  }
  return {};
}

std::string name_of(ClashGrouping grouping) {
  switch (grouping) {
    case ClashGrouping::none:
      return "none";
    case ClashGrouping::part:
      return "part";
    case ClashGrouping::region:
      return "region";
  }
  return {};
}

std::string name_of(Since since) {
  switch (since) {
    case Since::added:
      return "new";
    case Since::known:
      return "known";
    case Since::moved:
      return "moved";
    case Since::graver:
      return "graver";
  }
  return {};
}

std::string name_of(GoneReason reason) {
  switch (reason) {
    case GoneReason::apart:
      return "apart";
    case GoneReason::touching:
      return "touching";
    case GoneReason::left_out:
      return "left_out";
    case GoneReason::no_object:
      return "no_object";
  }
  return {};
}

}  // namespace toccata
