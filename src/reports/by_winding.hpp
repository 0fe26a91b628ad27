#pragma once

#include <span>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::io {

/// Adds the pairs of which one lies inside an open mesh by its generalised winding number, with no face of the two
/// meeting (ReportOptions::by_winding). Those that are wanted alone; without a filter all.
void add_contained_by_winding(std::span<const SceneInstance> models, const PairFilter& wanted, CheckReport& report);

}  // namespace toccata::io
