#pragma once

#include "toccata/narrow/set_relation.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// Exact, also where every pair of triangles merely touches: two aligned boxes that share half their volume overlap.
/// Throws like `overlap`.
[[nodiscard]] Relation relation(const Model& a, const Model& b, const PairQuery& query = {});

}  // namespace toccata
