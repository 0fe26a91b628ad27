#pragma once

#include <string>

#include "check_input.hpp"
#include "toccata/reports/report.hpp"

// The JSON lines of `check --stream` (docs/reference/check-report.md): a head, a line for each pair as it is found, and
// an end, without which what was told is not all.
namespace toccata::command {

[[nodiscard]] std::string stream_head(const Scene& scene);
[[nodiscard]] std::string stream_end(const CheckInput& input, const CheckReport& report);

}  // namespace toccata::command
