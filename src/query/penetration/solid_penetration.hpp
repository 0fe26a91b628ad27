#pragma once

#include <optional>

#include "query/ask.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

/// No half-space is one of several parts, and the two are not both half-spaces.
[[nodiscard]] bool may_be_parted(const PosedModel& a, const PosedModel& b);

/// The depth of two posed models of which some part is a mesh, or of which one has more than one part. `models` are a
/// and b. Throws Error when one is taken as a surface or has a half-space among several parts.
[[nodiscard]] DepthBracket depth_of_solids(const Model& a, const Model& b, const PairQuery& query,
                                           const PosedModelPair& models, const DepthOptions& options,
                                           Workspace& workspace);

/// Throws Error where a number is not as DepthOptions tells.
void require_usable(const DepthOptions& options);

/// What is told of two models in contact that lie so: nothing unless both are solids, the table of pairs.hpp defines
/// it, and they may be parted.
[[nodiscard]] std::optional<DepthBracket> depth_where_defined(const Model& a, const Model& b, const PairQuery& query,
                                                              const Relation& relation, const DepthOptions& options,
                                                              Workspace& workspace);

}  // namespace toccata
