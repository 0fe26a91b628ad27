#pragma once

#include <span>

#include "query/scenes/check_wanted.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::io {

/// What the rules say of pairs of the models.
[[nodiscard]] CheckPairRules pair_rules(const NameRules& rules, std::span<const SceneInstance> models);

}  // namespace toccata::io
