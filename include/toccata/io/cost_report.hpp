#pragma once

#include <span>
#include <string>

#include "toccata/query/check_all.hpp"
#include "toccata/query/cost.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// JSON by the schema toccata/cost/1 of docs/reference/cost-report.md; `scene` holds A and then B. Doubles round-trip.
[[nodiscard]] std::string cost_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                           const CostTable& table, std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per row.
[[nodiscard]] std::string cost_report_csv(const CostTable& table);

}  // namespace toccata
