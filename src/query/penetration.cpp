#include "toccata/query/penetration.hpp"

#include "query/ask.hpp"
#include "query/search_scratch.hpp"

namespace toccata {
namespace {

struct AskPenetration {
  static constexpr ShapeQuestion question = ShapeQuestion::penetration;

  Penetration operator()(const PosedConvex& a, const PosedConvex& b) const {
    return penetration(a, b, &scratch.convex);
  }
  Penetration operator()(const PosedConvex& a, const PosedHalfSpace& b) const { return penetration(a, b); }

  SearchScratch& scratch;
};

}  // namespace

Penetration penetration(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return penetration(a, b, query, workspace);
}

Penetration penetration(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  require_answered(ShapeQuestion::penetration, kind_of(a.shape()), kind_of(b.shape()));
  const PosedModels models(a, b, query);
  return ask(AskPenetration{workspace.scratch()}, models.a.parts[0], models.b.parts[0]);
}

}  // namespace toccata
