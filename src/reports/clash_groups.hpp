#pragma once

#include <vector>

#include "toccata/reports/report.hpp"

namespace toccata::io {

/// The pairs of a report that belong together, the largest group first, then that of the first pair.
[[nodiscard]] std::vector<ClashGroup> clash_groups(const std::vector<ReportedPair>& pairs, ClashGrouping grouping);

}  // namespace toccata::io
