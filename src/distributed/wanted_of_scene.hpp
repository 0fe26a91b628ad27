#pragma once

#include "query/scenes/check_wanted.hpp"
#include "toccata/distributed/distributed_scene.hpp"

namespace toccata {

/// What `DistributedScene::check` answers of the pairs that are wanted alone. Rules are of the numbers of all models,
/// and the same on all ranks; on rank 0 the counts are those of all.
[[nodiscard]] WantedAnswer check_wanted(DistributedScene& scene, const CheckOptions& options,
                                        const CheckPairRules& rules);

}  // namespace toccata
