#pragma once

#include <vector>

#include "io/formats/json_value.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::io {

/// What overlaps first, the deepest of it first, and of these what has no depth that could be told; then what may only
/// touch, what does only touch, what is near, the nearest first, and last what is within its tolerance. What is alike
/// stays in its order.
void sort_by_severity(std::vector<ReportedPair>& pairs);

/// The "sort" of a question: "objects", which is the standard, or "severity".
[[nodiscard]] PairOrder pair_order_of(const JsonValue& question);

}  // namespace toccata::io
