#pragma once

#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// The origin lies in the interior of A − B, the Minkowski difference of the hulls of the world vertices, their radii
/// left aside; exactly. For two hulls with an interior: the interiors meet. Where only one has an interior: the
/// other meets it. Where none has: their relative interiors meet, and they do not lie in one plane.
/// (ri(A − B) = ri A − ri B; R. T. Rockafellar, "Convex Analysis", 1970, §6.) `hint` may be any vertices, or none.
[[nodiscard]] bool interiors_meet(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& hint);

/// The origin lies strictly within the tetrahedron of four vertices of A − B; exactly.
[[nodiscard]] bool origin_within_tetrahedron(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& four);

}  // namespace toccata
