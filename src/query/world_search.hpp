#pragma once

#include <functional>

#include "query/posed_mesh.hpp"

namespace toccata {

/// Calls `visit(triangle)` for exactly those triangles whose world boxes meet `region`, a closed world box, in no
/// particular but always the same order; ends early when `visit` returns false. A side of the region may be infinite:
/// the ray from p along +x is {p, {∞, p.y, p.z}}.
void visit_triangles_near(const PosedMesh& mesh, const Aabb& region, const std::function<bool(Index)>& visit);

}  // namespace toccata
