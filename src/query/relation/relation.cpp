#include "toccata/query/relation.hpp"

#include <algorithm>
#include <utility>

#include "query/ask.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/near_parts.hpp"
#include "query/posed_mesh_pair.hpp"
#include "query/relation/relation_posed.hpp"
#include "query/relation/relation_solids.hpp"
#include "query/relation/relation_unions.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {
namespace {

Relation relation_of_surfaces(VisitContacts visit) {
  Relation result;
  visit([&](const Contact& contact) {
    result.kind = contact.intersection.crossing ? RelationKind::crossing : RelationKind::touching;
    return !contact.intersection.crossing;
  });
  result.side_unresolved = result.kind == RelationKind::touching;
  return result;
}

Relation relation_as_taken(const PosedTrianglesView& a, const PosedTrianglesView& b, VisitContacts visit) {
  if (a.solid && b.solid) return relation_of_solids(a.mesh, b.mesh, visit);
  if (a.solid) return relation_of_solid_and_surface(a.mesh, b.mesh, visit);
  if (!b.solid) return relation_of_surfaces(visit);
  Relation result = relation_of_solid_and_surface(
      b.mesh, a.mesh, [&](SeeContact see) { visit([&](const Contact& contact) { return see(flipped(contact)); }); });
  result.containment = flipped(result.containment);
  return result;
}

Relation relation_with(const PosedTrianglesView& a, const PosedTrianglesView& b, VisitContacts visit) {
  Relation result = relation_as_taken(a, b, visit);
  result.a_solid = a.solid;
  result.b_solid = b.solid;
  return result;
}

}  // namespace

Relation relation_of(const PosedTrianglesView& a, const PosedTrianglesView& b, SearchScratch& scratch) {
  return relation_with(a, b, [&](SeeContact see) { visit_surface_contacts(a.mesh, b.mesh, scratch, see); });
}

Relation relation_of(const PosedTrianglesView& a, const PosedTrianglesView& b, std::span<const Contact> contacts) {
  return relation_with(a, b,
                       [&](SeeContact see) { static_cast<void>(std::all_of(contacts.begin(), contacts.end(), see)); });
}

namespace {

struct AskRelation {
  static constexpr ShapeQuestion question = ShapeQuestion::relation;

  Relation operator()(const PosedPolytope& a, const PosedPolytope& b) const { return relation(a, b, &scratch.convex); }
  Relation operator()(const PosedPolytope& a, const PosedHalfSpace& b) const { return relation(a, b); }
  Relation operator()(const PosedHalfSpace& a, const PosedHalfSpace& b) const { return relation(a, b); }
  Relation operator()(const PosedTriangles& a, const PosedQuadric& b) const { return relation(a, b); }
  template <PosedConvexSet Other>
  Relation operator()(const PosedQuadric& a, const Other& b) const {
    return relation(a, b);
  }
  Relation operator()(const PosedTriangles& a, const PosedPolytope& b) const { return relation(a, b); }
  Relation operator()(const PosedTriangles& a, const PosedHalfSpace& b) const { return relation(a, b); }
  Relation operator()(const PosedTriangles& a, const PosedTriangles& b) const {
    return relation_of({a.mesh, a.solid}, {b.mesh, b.solid}, scratch);
  }

  SearchScratch& scratch;
};

}  // namespace

Relation relation_of(const PosedModel& a, const PosedModel& b, SearchScratch& scratch) {
  if (a.parts.size() == 1 && b.parts.size() == 1) return ask(AskRelation{scratch}, a.parts[0], b.parts[0]);
  RelationOfUnions all(a, b);
  require_all_answered(ShapeQuestion::relation, a, b);
  // Parts whose boxes are apart are apart.
  NearParts pairs(a, b, gap_of_parts, 0, scratch);
  while (const std::optional<ItemPair> next = pairs.next(0))
    all.add(*next, ask(AskRelation{scratch}, a.parts[next->first], b.parts[next->second]));
  return all.relation();
}

Relation relation(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return relation(a, b, query, workspace);
}

Relation relation(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  SearchScratch& scratch = workspace.scratch();
  if (a.has_mesh() && b.has_mesh()) {
    const PosedMeshPair pair(a, b, query);
    return relation_of({pair.a, pair.a_solid}, {pair.b, pair.b_solid}, scratch);
  }
  const PosedModelPair models(a, b, query, scratch);
  return relation_of(models.a, models.b, scratch);
}

}  // namespace toccata
