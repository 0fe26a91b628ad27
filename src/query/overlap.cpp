#include "toccata/query/overlap.hpp"

#include <algorithm>

#include "query/pair_search.hpp"
#include "query/posed_pair.hpp"
#include "query/relation_parts.hpp"

namespace toccata {
namespace {

/// The surfaces do not meet, so every connected part of one lies as a whole inside the other or outside it.
bool has_part_inside(const PosedMesh& mesh, const PosedMesh& solid) {
  const auto parts = mesh.model().part_vertices();
  return std::any_of(parts.begin(), parts.end(), [&](Index number) {
    const Vec3 vertex = mesh.vertex(number);
    return contains(solid.box(), {vertex, vertex}) && is_interior(vertex, solid);
  });
}

}  // namespace

bool overlap(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return overlap(a, b, query, workspace);
}

bool overlap(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedPair pair(a, b, query);
  return overlap(pair.a.box(), pair.b.box()) &&
         (surfaces_meet(pair.a, pair.b, workspace.scratch()) || (pair.b_solid && has_part_inside(pair.a, pair.b)) ||
          (pair.a_solid && has_part_inside(pair.b, pair.a)));
}

}  // namespace toccata
