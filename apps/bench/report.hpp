#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "measure.hpp"

namespace toccata::bench {

/// The report's head: format, version, processor, compiler, and what was asked.
nlohmann::ordered_json report_of(const std::string& benchmark, nlohmann::ordered_json question);

/// What a library cannot be asked, and why.
struct NotMeasured {
  Description who;
  std::string task;
  int threads = 1;
  std::string reason;
};

/// The first result is Toccata's.
struct Measurements {
  std::vector<Result> results;
  std::vector<NotMeasured> not_measured;
};

/// Prints a table for people, or JSON with `results` and `ratios`; gives the exit code.
int print_results(nlohmann::ordered_json report, const Measurements& measurements, bool json);

}  // namespace toccata::bench
