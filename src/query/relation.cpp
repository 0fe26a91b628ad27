#include "toccata/query/relation.hpp"

#include <utility>

#include "query/pair_search.hpp"
#include "query/posed_pair.hpp"
#include "query/relation_posed.hpp"
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

Relation relation_as_taken(const TakenMesh& a, const TakenMesh& b) {
  if (a.solid && b.solid) return relation_of_solids(a.mesh, b.mesh);
  if (a.solid) return relation_of_solid_and_surface(a.mesh, b.mesh);
  if (!b.solid) return relation_of_surfaces(a.mesh, b.mesh);
  Relation result = relation_of_solid_and_surface(b.mesh, a.mesh);
  result.containment = flipped(result.containment);
  return result;
}

}  // namespace

Relation relation_of(const TakenMesh& a, const TakenMesh& b) {
  Relation result = relation_as_taken(a, b);
  result.a_solid = a.solid;
  result.b_solid = b.solid;
  return result;
}

Relation relation(const Model& a, const Model& b, const PairQuery& query) {
  const PosedPair pair(a, b, query);
  return relation_of({pair.a, pair.a_solid}, {pair.b, pair.b_solid});
}

}  // namespace toccata
