#pragma once

#include <optional>

#include "query/search_scratch.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// How deep two closed meshes, both taken as solids, are in each other where they are deepest: the greatest sum of a
/// point's distances from the two surfaces, over all points of both (docs/methods/penetration.md#how-deep-is-a-place).
/// Known as well as it takes to hold it against the limit: `upper` is at most that, or infinite, where that could be
/// told. It is infinite where `lower` is more than the limit, and where a mesh intersects itself or lies within itself
/// there, since what looks like its surface may be inside it.
[[nodiscard]] ContactRegion::Depth local_depth_against(double limit, const Model& a, const Model& b,
                                                       const PairQuery& query, SearchScratch& scratch);

/// A point inside of both, off their surfaces, exactly: one that the same search looks at. None where it finds none in
/// reasonable time.
[[nodiscard]] std::optional<Vec3> inner_common_point(const Model& a, const Model& b, const PairQuery& query,
                                                     SearchScratch& scratch);

}  // namespace toccata
