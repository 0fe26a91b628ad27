#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "arguments.hpp"
#include "check_input.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/reports/scene_question.hpp"

namespace CLI {
class App;
}

// What a check found, in files for other programs: JUnit XML and SARIF for continuous integration, BCF, by which
// programs for building models exchange issues, and GLB of what solids have in common (docs/reference/exchange.md).
namespace toccata::command {

/// Whether a pair makes the check fail.
using IsFailure = std::function<bool(const ReportedPair&)>;

/// What a check found, and of which files.
struct Findings {
  const CheckInput& input;
  const CheckReport& report;
  const PosedArguments& arguments;
  IsFailure is_failure;
};

[[nodiscard]] std::string junit_xml(const Findings& findings);
[[nodiscard]] std::string sarif_json(const Findings& findings);
/// A zip.
[[nodiscard]] std::string bcf_zip(const Findings& findings);

/// What a file is to hold.
struct ExchangeContent {
  std::function<void(const std::filesystem::path&)> write;
  std::string holds;         ///< how much that is, in words
  bool was_stopped = false;  ///< before it was all
};

/// What is told of the files that were written.
struct ExchangeTold {
  std::string lines;
  bool was_stopped = false;  ///< one of them does not hold all
};

/// Warns of the pairs that have no body. Takes long, and tells how far it is; at the time limit the others have none.
[[nodiscard]] ExchangeContent overlap_bodies_content(const Findings& findings);

/// --junit, --sarif, --bcf and --overlap-bodies.
void add_exchange(CLI::App& app, ExchangeFiles& files);

/// Throws Error, before long work, naming the file that cannot be written.
void require_exchange(const PosedArguments& arguments);

/// Writes those that the arguments name, and returns a line about each. Throws Error where the answer is none of a
/// check of pairs and some are named.
ExchangeTold write_exchange(const CheckInput& input, const SceneAnswer& answer, const PosedArguments& arguments,
                            const IsFailure& is_failure);

}  // namespace toccata::command
