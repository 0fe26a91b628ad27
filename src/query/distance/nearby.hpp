#pragma once

#include <optional>

#include "narrow/near.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// How near two posed models are: of their parts, the nearest. Throws Error for a pose that a model may not have.
[[nodiscard]] std::optional<Nearby> nearby(const Model& a, const Model& b, const WantedDistance& wanted,
                                           const PairQuery& query, Workspace& workspace);

}  // namespace toccata
