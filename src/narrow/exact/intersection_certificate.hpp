#pragma once

#include <optional>

#include "math/bounded_number.hpp"
#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// The origin is in the hull of four vertices of the Minkowski difference; the signs are exact.
[[nodiscard]] bool contains_origin(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex);

/// The point of A that has the same weights among its vertices as the origin among the simplex of four pairs.
[[nodiscard]] BoundedVector common_point(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& simplex);

/// The same in doubles, off by no more than 2⁻⁴¹ of the greatest coordinate of a vertex; nothing where these do not
/// tell that, and that the origin is in the hull.
[[nodiscard]] std::optional<Vec3> plain_common_point(const PosedPolytope& a, const PosedPolytope& b,
                                                     const VertexPairs& simplex);

}  // namespace toccata
