#pragma once

#include <array>

#include "query/meshes/posed_mesh.hpp"
#include "toccata/core/function_ref.hpp"

namespace toccata {

/// A box in the world with sides along directions of its own: the points p with low[i] <= direction[i] · p <= high[i].
struct WorldShaft {
  std::array<Vec3, 3> directions;
  Vec3 low;
  Vec3 high;
  Vec3 reach;  ///< no coordinate of a point in it is greater
};

/// Calls `visit(triangle)` for all triangles that meet it, and for such as the tree cannot tell from these, in no
/// particular but always the same order; ends early when `visit` returns false.
void visit_triangles_in(const PosedMesh& mesh, const WorldShaft& shaft, FunctionRef<bool(Index)> visit);

}  // namespace toccata
