#include "toccata/query/distance.hpp"

#include "math/constants.hpp"
#include "query/ask.hpp"
#include "query/distance/least_distance.hpp"
#include "query/distance/mesh_distance.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

struct AskDistance {
  static constexpr ShapeQuestion question = ShapeQuestion::distance;

  Distance operator()(const PosedPolytope& a, const PosedPolytope& b) const { return distance(a, b, &scratch.convex); }
  Distance operator()(const PosedPolytope& a, const PosedHalfSpace& b) const { return distance(a, b); }
  Distance operator()(const PosedHalfSpace& a, const PosedHalfSpace& b) const { return distance(a, b); }
  template <PosedConvexSet Other>
  Distance operator()(const PosedQuadric& a, const Other& b) const {
    return distance(a, b);
  }
  template <class Other>
  Distance operator()(const PosedTriangles& a, const Other& b) const {
    return distance(a, b, scratch);
  }

  SearchScratch& scratch;
};

}  // namespace

Distance distance(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return distance(a, b, query, workspace);
}

Distance distance(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedModelPair models(a, b, query, workspace.scratch());
  LeastDistance least(workspace.scratch());
  models.visit_near(infinity, [&](const PosedPart& part_a, const PosedPart& part_b) {
    if (!least.is_farther(part_a, part_b))
      least.keep(ask(AskDistance{workspace.scratch()}, part_a, part_b), part_a, part_b);
    return least.limit(infinity);
  });
  return *least.found();
}

}  // namespace toccata
