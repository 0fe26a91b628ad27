#pragma once

#include "query/search_scratch.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// How deep two closed meshes, both taken as solids, are in each other where they are deepest: the greatest sum of a
/// point's distances from the two surfaces, over all points of both (docs/methods/penetration.md#how-deep-is-a-place).
/// Known as well as it takes to hold it against the limit: `upper` is at most that, or `lower` more, where that could
/// be told. `upper` is infinite where a mesh intersects itself or lies within itself there, since what looks like its
/// surface may be inside it, and where it is not needed.
[[nodiscard]] ContactRegion::Depth local_depth_against(double limit, const Model& a, const Model& b,
                                                       const PairQuery& query, SearchScratch& scratch);

}  // namespace toccata
