#include "toccata/query/relation.hpp"

#include <utility>

#include "query/pair_search.hpp"
#include "query/posed_pair.hpp"
#include "query/relation_solids.hpp"

namespace toccata {
namespace {

Containment flipped(Containment containment) {
  if (containment == Containment::a_in_b) return Containment::b_in_a;
  if (containment == Containment::b_in_a) return Containment::a_in_b;
  return containment;
}

Relation relation_of_surfaces(const PosedMesh& a, const PosedMesh& b) {
  Relation result;
  visit_surface_contacts(a, b, [&](const Contact& contact) {
    result.kind = contact.meeting.crossing ? RelationKind::crossing : RelationKind::touching;
    return !contact.meeting.crossing;
  });
  result.side_unresolved = result.kind == RelationKind::touching;
  return result;
}

Relation relation_of(const PosedPair& pair) {
  if (pair.a_solid && pair.b_solid) return relation_of_solids(pair.a, pair.b);
  if (pair.a_solid) return relation_of_solid_and_surface(pair.a, pair.b);
  if (!pair.b_solid) return relation_of_surfaces(pair.a, pair.b);
  Relation result = relation_of_solid_and_surface(pair.b, pair.a);
  result.containment = flipped(result.containment);
  return result;
}

}  // namespace

Relation relation(const Model& a, const Model& b, const PairQuery& query) {
  const PosedPair pair(a, b, query);
  Relation result = relation_of(pair);
  result.a_solid = pair.a_solid;
  result.b_solid = pair.b_solid;
  return result;
}

}  // namespace toccata
