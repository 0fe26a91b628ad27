#pragma once

#include <span>

#include "query/scenes/check_wanted.hpp"
#include "reports/baseline.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::io {

/// What a check asks of the pairs of models, of which only names and groups count. Throws Error where it leaves no
/// pair, and where it asks for the clearance of one that it leaves out.
[[nodiscard]] CheckPairRules rules_of(const CheckQuestion& question, std::span<const SceneInstance> models);

/// The report on what was found by these rules: against the baseline, in its order and groups.
[[nodiscard]] CheckReport report_on(const CheckQuestion& question, const Checked& checked, const WantedAnswer& found);

}  // namespace toccata::io
