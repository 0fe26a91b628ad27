#include "toccata/query/penetration.hpp"

#include "query/ask.hpp"
#include "query/penetration/solid_penetration.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

bool is_one_shape(const Model& model) { return !model.has_mesh() && kind_of(model.shape()) != ShapeKind::compound; }

/// Of convex sets, not two half-spaces.
struct AskDepth {
  Penetration operator()(const PosedPolytope& a, const PosedPolytope& b) const {
    return penetration(a, b, &scratch.convex);
  }
  Penetration operator()(const PosedPolytope& a, const PosedHalfSpace& b) const { return penetration(a, b); }
  Penetration operator()(const PosedHalfSpace& a, const PosedPolytope& b) const { return flipped(penetration(b, a)); }
  Penetration operator()(const PosedHalfSpace& a, const PosedQuadric& b) const { return penetration(a, b); }
  Penetration operator()(const PosedPolytope& a, const PosedQuadric& b) const { return penetration(a, b); }
  template <PosedConvexSet B>
  Penetration operator()(const PosedQuadric& a, const B& b) const {
    return penetration(a, b);
  }
  template <class A, class B>
  Penetration operator()(const A&, const B&) const {
    return {};  // the table was asked before
  }

  SearchScratch& scratch;
};

/// The table was asked before.
Penetration penetration_of(const Model& a, const Model& b, const PairQuery& query, const PosedModelPair& models,
                           Workspace& workspace) {
  if (is_one_shape(a) && is_one_shape(b))
    return std::visit(AskDepth{workspace.scratch()}, models.a.parts[0].shape, models.b.parts[0].shape);
  return penetration_of_solids(a, b, query, models, workspace);
}

}  // namespace

Penetration penetration(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return penetration(a, b, query, workspace);
}

Penetration penetration(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  require_answered(ShapeQuestion::penetration, kind_of(a.shape()), kind_of(b.shape()));
  return penetration_of(a, b, query, PosedModelPair(a, b, query, workspace.scratch()), workspace);
}

std::optional<Penetration> penetration_where_defined(const Model& a, const Model& b, const PairQuery& query,
                                                     const Relation& relation, Workspace& workspace) {
  if (!relation.a_solid || !relation.b_solid || !is_defined(ShapeQuestion::penetration, a, b)) return std::nullopt;
  const PosedModelPair models(a, b, query, workspace.scratch());
  if (!may_be_parted(models.a, models.b)) return std::nullopt;
  return penetration_of(a, b, query, models, workspace);
}

}  // namespace toccata
