#include "toccata/query/overlap.hpp"

#include <algorithm>
#include <vector>

#include "query/pair_search.hpp"
#include "query/posed_pair.hpp"
#include "query/relation_locality.hpp"

namespace toccata {
namespace {

/// The surfaces do not meet, so every connected part of one lies as a whole inside the other or outside it.
bool has_part_inside(const PosedMesh& mesh, const PosedMesh& solid) {
  const std::vector<Index>& parts = mesh.model().mesh_parts().first_triangle;
  return std::any_of(parts.begin(), parts.end(),
                     [&](Index triangle) { return is_interior(mesh.triangle(triangle)[0], solid); });
}

}  // namespace

bool overlap(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return overlap(a, b, query, workspace);
}

bool overlap(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedPair pair(a, b, query);
  workspace.scratch().counts = {};
  return overlap(pair.a.box(), pair.b.box()) &&
         (surfaces_meet(pair.a, pair.b, workspace.scratch()) || (pair.b_solid && has_part_inside(pair.a, pair.b)) ||
          (pair.a_solid && has_part_inside(pair.b, pair.a)));
}

}  // namespace toccata
