#include "toccata/query/penetration.hpp"

#include <fmt/format.h>

#include <cmath>

#include "query/ask.hpp"
#include "query/penetration/depth_search.hpp"
#include "query/penetration/solid_penetration.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

bool is_one_shape(const Model& model) { return !model.has_mesh() && kind_of(model.shape()) != ShapeKind::compound; }

/// Asks for the depth of two convex sets, which are not both half-spaces.
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
DepthBracket depth_of(const Model& a, const Model& b, const PairQuery& query, const PosedModelPair& models,
                      const DepthOptions& options, Workspace& workspace) {
  if (!is_one_shape(a) || !is_one_shape(b)) return depth_of_solids(a, b, query, models, options, workspace);
  const Penetration depth = std::visit(AskDepth{workspace.scratch()}, models.a.parts[0].shape, models.b.parts[0].shape);
  const bool is_precise = depth.status == Status::exact || DepthLimit(options).is_narrow(depth);
  return {depth, is_precise ? DepthEnd::precise : DepthEnd::exhausted};
}

}  // namespace

void require_usable(const DepthOptions& options) {
  if (!(options.precision > 0) || !std::isfinite(options.precision))
    throw Error(
        fmt::format("penetration: the precision is {}; give a number above 0, 0.1 for a bracket that is 10 % wide",
                    options.precision));
  if (!(options.time_limit > 0))
    throw Error(fmt::format("penetration: the time limit is {}; give seconds above 0, or infinity for none",
                            options.time_limit));
}

Penetration penetration(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return penetration(a, b, query, workspace);
}

Penetration penetration(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  return depth_bracket(a, b, query, {}, workspace).penetration;
}

DepthBracket depth_bracket(const Model& a, const Model& b, const PairQuery& query, const DepthOptions& options) {
  Workspace workspace;
  return depth_bracket(a, b, query, options, workspace);
}

DepthBracket depth_bracket(const Model& a, const Model& b, const PairQuery& query, const DepthOptions& options,
                           Workspace& workspace) {
  require_usable(options);
  require_answered(ShapeQuestion::penetration, kind_of(a.shape()), kind_of(b.shape()));
  return depth_of(a, b, query, PosedModelPair(a, b, query, workspace.scratch()), options, workspace);
}

std::optional<DepthBracket> depth_where_defined(const Model& a, const Model& b, const PairQuery& query,
                                                const Relation& relation, const DepthOptions& options,
                                                Workspace& workspace) {
  if (!relation.a_solid || !relation.b_solid || !is_defined(ShapeQuestion::penetration, a, b)) return std::nullopt;
  const PosedModelPair models(a, b, query, workspace.scratch());
  if (!may_be_parted(models.a, models.b)) return std::nullopt;
  return depth_of(a, b, query, models, options, workspace);
}

}  // namespace toccata
