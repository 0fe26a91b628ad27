#include "toccata/query/penetration.hpp"

#include "query/ask.hpp"

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
  return ask_single<AskPenetration>(a, b, query, workspace.scratch());
}

}  // namespace toccata
