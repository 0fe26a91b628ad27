#pragma once

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"
#include "toccata/query/workspace.hpp"

namespace toccata {

/// The distance of the two posed models, certified; 0 when they meet. Of a compound it is the least of its parts, by
/// (upper, element of A, element of B). This version answers it for convex shapes, half-spaces and compounds of them.
/// Throws like `overlap`, and Error for meshes and height fields.
[[nodiscard]] Distance distance(const Model& a, const Model& b, const PairQuery& query = {});

/// The same, for a caller who asks often.
[[nodiscard]] Distance distance(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace);

}  // namespace toccata
