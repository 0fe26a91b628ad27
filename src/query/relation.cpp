#include "toccata/query/relation.hpp"

#include <algorithm>
#include <functional>
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

Contact flipped(const Contact& c) { return {c.triangle_b, c.triangle_a, c.face_b, c.face_a, flipped(c.meeting)}; }

VisitContacts flipped(const VisitContacts& visit) {
  return [&visit](const std::function<bool(const Contact&)>& see) {
    visit([&](const Contact& contact) { return see(flipped(contact)); });
  };
}

Relation relation_of_surfaces(const VisitContacts& visit) {
  Relation result;
  visit([&](const Contact& contact) {
    result.kind = contact.meeting.crossing ? RelationKind::crossing : RelationKind::touching;
    return !contact.meeting.crossing;
  });
  result.side_unresolved = result.kind == RelationKind::touching;
  return result;
}

Relation relation_as_taken(const TakenMesh& a, const TakenMesh& b, const VisitContacts& visit) {
  if (a.solid && b.solid) return relation_of_solids(a.mesh, b.mesh, visit);
  if (a.solid) return relation_of_solid_and_surface(a.mesh, b.mesh, visit);
  if (!b.solid) return relation_of_surfaces(visit);
  Relation result = relation_of_solid_and_surface(b.mesh, a.mesh, flipped(visit));
  result.containment = flipped(result.containment);
  return result;
}

Relation relation_with(const TakenMesh& a, const TakenMesh& b, const VisitContacts& visit) {
  Relation result = relation_as_taken(a, b, visit);
  result.a_solid = a.solid;
  result.b_solid = b.solid;
  return result;
}

}  // namespace

Relation relation_of(const TakenMesh& a, const TakenMesh& b) {
  return relation_with(
      a, b, [&](const std::function<bool(const Contact&)>& see) { visit_surface_contacts(a.mesh, b.mesh, see); });
}

Relation relation_of(const TakenMesh& a, const TakenMesh& b, std::span<const Contact> contacts) {
  return relation_with(a, b, [&](const std::function<bool(const Contact&)>& see) {
    static_cast<void>(std::all_of(contacts.begin(), contacts.end(), see));
  });
}

Relation relation(const Model& a, const Model& b, const PairQuery& query) {
  const PosedPair pair(a, b, query);
  return relation_of({pair.a, pair.a_solid}, {pair.b, pair.b_solid});
}

}  // namespace toccata
