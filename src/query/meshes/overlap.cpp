#include "toccata/query/overlap.hpp"

#include "query/ask.hpp"
#include "query/inside/part_inside.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/meshes/triangles_shape.hpp"
#include "query/posed_mesh_pair.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

bool meshes_overlap(const PosedMesh& a, bool a_solid, const PosedMesh& b, bool b_solid, SearchScratch& scratch) {
  return overlap(a.box(), b.box()) &&
         (surfaces_meet(a, b, scratch) || (b_solid && part_inside(a, b)) || (a_solid && part_inside(b, a)));
}

struct AskOverlap {
  static constexpr ShapeQuestion question = ShapeQuestion::overlap;

  bool operator()(const PosedPolytope& a, const PosedPolytope& b) const { return overlap(a, b, &scratch.convex); }
  bool operator()(const PosedPolytope& a, const PosedHalfSpace& b) const { return overlap(a, b); }
  bool operator()(const PosedHalfSpace& a, const PosedHalfSpace& b) const { return overlap(a, b); }
  bool operator()(const PosedTriangles& a, const PosedQuadric& b) const { return overlap(a, b); }
  template <PosedConvexSet Other>
  bool operator()(const PosedQuadric& a, const Other& b) const {
    return overlap(a, b);
  }
  bool operator()(const PosedTriangles& a, const PosedPolytope& b) const { return overlap(a, b); }
  bool operator()(const PosedTriangles& a, const PosedHalfSpace& b) const { return overlap(a, b); }
  bool operator()(const PosedTriangles& a, const PosedTriangles& b) const {
    return meshes_overlap(a.mesh, a.solid, b.mesh, b.solid, scratch);
  }

  SearchScratch& scratch;
};

bool shapes_overlap(const Model& a, const Model& b, const PairQuery& query, SearchScratch& scratch) {
  const PosedModelPair models(a, b, query, scratch);
  bool found = false;
  models.visit_near(0, [&](const PosedPart& x, const PosedPart& y) {
    found = ask(AskOverlap{scratch}, x, y);
    return found ? -1.0 : 0.0;
  });
  return found;
}

}  // namespace

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
