#pragma once

#include <span>

#include "query/scenes/check_wanted.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::io {

/// Which pairs of the models the rules leave to be checked; empty where there are none.
[[nodiscard]] PairFilter wanted_pairs(const NameRules& rules, std::span<const SceneInstance> models);

/// The tolerance of each pair that a rule tells one of; empty where no rule does.
[[nodiscard]] PairTolerances tolerances_of(const NameRules& rules, std::span<const SceneInstance> models);

}  // namespace toccata::io
