#pragma once

#include <span>

#include "io/formats/json.hpp"
#include "io/formats/json_value.hpp"
#include "query/scenes/check_wanted.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::io {

/// What was checked now.
struct Checked {
  std::span<const SceneInstance> models;  ///< of which names and groups count, and with `by_winding` all else
  const CheckPairRules& rules;
  FunctionRef<FormerObject(Index model)> placed;  ///< how it lies now; its name does not count
};

/// Tells of each pair of the report what it was in the baseline and how far it has moved since, and which pairs of that
/// are gone. The tolerance is that of the pairs that have none of their own.
void compare_with(const Baseline& baseline, const Checked& checked, const CheckAnswer& answer, double tolerance,
                  CheckReport& report);

[[nodiscard]] Json json_of(const FormerPair& pair);
/// Its depths and its volume alone, as far as they are known.
[[nodiscard]] Json json_of_extent(const FormerPair& pair);
[[nodiscard]] Json json_of(const Baseline& baseline);

/// Back from JSON.
[[nodiscard]] Baseline baseline_of(const JsonValue& value);

}  // namespace toccata::io
