#include "toccata/query/overlap.hpp"

#include "query/ask.hpp"
#include "query/distance/mesh_distance.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/near_parts.hpp"
#include "query/part_questions.hpp"
#include "query/posed_mesh_pair.hpp"
#include "query/search_scratch.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

struct AskOverlap {
  static constexpr ShapeQuestion question = ShapeQuestion::overlap;

  template <class A, class B>
  requires requires(const A& a, const B& b) { overlap(a, b); }
  bool operator()(const A& a, const B& b) const { return overlap(a, b); }
  bool operator()(const PosedPolytope& a, const PosedPolytope& b) const { return overlap(a, b, &scratch.convex); }
  bool operator()(const PosedTriangles& a, const PosedTriangles& b) const {
    return meshes_overlap(a.mesh, a.solid, b.mesh, b.solid, scratch);
  }

  SearchScratch& scratch;
};

bool shapes_overlap(const Model& a, const Model& b, const PairQuery& query, SearchScratch& scratch) {
  const PosedModelPair models(a, b, query, scratch);
  const AskOverlap question{scratch};
  if (models.are_single()) return ask(question, models.a.parts[0], models.b.parts[0]);
  NearParts pairs(models.a, models.b, gap_of_parts, 0, scratch);
  while (const std::optional<ItemPair> next = pairs.next(0))
    if (ask(question, models.a.parts[next->first], models.b.parts[next->second])) return true;
  return false;
}

}  // namespace

bool parts_overlap(const PosedPart& a, const PosedPart& b, SearchScratch& scratch) {
  return ask(AskOverlap{scratch}, a, b);
}

bool overlap(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return overlap(a, b, query, workspace);
}

bool overlap(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  workspace.scratch().counts = {};
  if (!a.has_mesh() || !b.has_mesh()) return shapes_overlap(a, b, query, workspace.scratch());
  const PosedMeshPair pair(a, b, query);
  return meshes_overlap(pair.a, pair.a_solid, pair.b, pair.b_solid, workspace.scratch());
}

}  // namespace toccata
