#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "measure.hpp"

namespace toccata::bench {

/// The report's head: format, version, processor, compiler, and what was asked.
nlohmann::ordered_json report_of(const std::string& benchmark, nlohmann::ordered_json question);

/// How many times as long a peer takes as the first result, which is Toccata.
nlohmann::ordered_json ratios_of(const std::vector<Result>& results);

/// Prints a table for people, or JSON with `results` and `ratios`; gives the exit code.
int print_results(nlohmann::ordered_json report, const std::vector<Result>& results, bool json);

}  // namespace toccata::bench
