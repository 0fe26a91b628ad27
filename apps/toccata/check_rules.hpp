#pragma once

#include <span>
#include <string>
#include <vector>

#include "clearance.hpp"
#include "toccata/reports/report.hpp"

namespace CLI {
class App;
}

// Which pairs `check` looks at: rules from files and from the command line (docs/reference/check-rules.md).
namespace toccata::command {

/// As they are written, in their order.
struct RuleArguments {
  std::vector<std::string> files;    ///< --rules
  std::vector<std::string> ignored;  ///< --ignore: what follows that word in a file
  std::vector<std::string> between;  ///< --between, the same way
};

bool has_rules(const RuleArguments& arguments);

void add_rules(CLI::App& app, RuleArguments& arguments);

/// Adds a warning for each rule and set that no object of the scene is in. Throws Error naming the file and the line,
/// or the option, for what is no rule; and where the rules leave no pair to be checked.
NameRules read_rules(const RuleArguments& arguments, std::span<const SceneInstance> models, const LengthUnits& units,
                     std::vector<std::string>& warnings);

}  // namespace toccata::command
