#include "toccata/query/manifold.hpp"

#include "query/ask.hpp"
#include "query/contacts/part_contacts.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

struct AskManifold {
  static constexpr ShapeQuestion question = ShapeQuestion::manifold;

  Manifold operator()(const PosedPolytope& a, const PosedPolytope& b) const { return manifold(a, b, &scratch.convex); }
  Manifold operator()(const PosedPolytope& a, const PosedHalfSpace& b) const { return manifold(a, b); }
  template <PosedConvexSet Other>
  Manifold operator()(const PosedQuadric& a, const Other& b) const {
    return manifold(a, b);
  }

  SearchScratch& scratch;
};

}  // namespace

Manifold manifold(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return manifold(a, b, query, workspace);
}

Manifold manifold(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  return ask_single<AskManifold>(a, b, query, workspace.scratch());
}

std::optional<Manifold> manifold_where_defined(const Model& a, const Model& b, const PairQuery& query,
                                               Workspace& workspace) {
  if (!is_defined(ShapeQuestion::manifold, a, b)) return std::nullopt;
  return manifold(a, b, query, workspace);
}

template <std::same_as<Contact> C>
Manifold manifold(const Model& a, const Model& b, const C& contact, const PairQuery& query) {
  SearchScratch scratch;
  const PosedModelPair models(a, b, query, scratch);
  return manifold_of(posed_element(models.a, contact.element_a), posed_element(models.b, contact.element_b), scratch);
}

template Manifold manifold(const Model&, const Model&, const Contact&, const PairQuery&);

Manifold manifold_of(const PosedPart& a, const PosedPart& b, SearchScratch& scratch) {
  return ask(AskManifold{scratch}, a, b);
}

}  // namespace toccata
