#include "toccata/query/penetration.hpp"

#include "query/ask.hpp"
#include "query/penetration/solid_penetration.hpp"

namespace toccata {
namespace {

bool is_one_shape(const Model& model) { return !model.has_mesh() && kind_of(model.shape()) != ShapeKind::compound; }

/// Of convex shapes and half-spaces, not two of these.
Penetration of_shapes(const PosedShape& a, const PosedShape& b, SearchScratch& scratch) {
  const auto *convex_a = std::get_if<PosedConvex>(&a), *convex_b = std::get_if<PosedConvex>(&b);
  if (convex_a != nullptr && convex_b != nullptr) return penetration(*convex_a, *convex_b, &scratch.convex);
  if (convex_b == nullptr) return penetration(*convex_a, std::get<PosedHalfSpace>(b));
  return flipped(penetration(*convex_b, std::get<PosedHalfSpace>(a)));
}

}  // namespace

Penetration penetration(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return penetration(a, b, query, workspace);
}

Penetration penetration(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  require_answered(ShapeQuestion::penetration, kind_of(a.shape()), kind_of(b.shape()));
  const PosedModels models(a, b, query, workspace.scratch());
  if (is_one_shape(a) && is_one_shape(b))
    return of_shapes(models.a.parts[0].shape, models.b.parts[0].shape, workspace.scratch());
  return penetration_of_solids(a, b, query, models, workspace);
}

}  // namespace toccata
