#pragma once

#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "check_rules.hpp"
#include "clearance.hpp"
#include "load.hpp"
#include "toccata/reports/scene_question.hpp"

namespace CLI {
class App;
}

// What `check` asks about the pairs of a scene, in words and as a question: of one process and over ranks.
namespace toccata::command {

/// What counts as found, for the exit code.
enum class FailOn { any, hard, added };

/// With what only `check` has of options about the pairs of a scene.
struct CheckCommand : CheckArguments {
  RuleArguments rules;
  std::string baseline;  ///< a file; empty: none
  PairOrder order = PairOrder::objects;
  ClashGrouping grouping = ClashGrouping::none;
  FailOn fail_on = FailOn::any;
  bool by_winding = false;  ///< what is inside open meshes
  bool volume = false;
  std::string tolerance;  ///< a length; empty: none

  // As they are written.
  std::string order_word = "objects", fail_on_word = "any", group_word = "none";
};

/// How deep, how much, and whether touching counts.
void add_pair_questions(CLI::App& check, CheckCommand& arguments);

/// Which pairs are told, and which of them are clashes.
void add_rules_of_clashes(CLI::App& check, CheckCommand& arguments);

/// What fails, and how the pairs are ordered.
void add_order(CLI::App& check, CheckCommand& arguments);

/// Takes the words in, and throws Error where they exclude each other.
void take_choices(CheckCommand& arguments);

/// Throws Error where options are about depths, and nothing asks for them.
void require_depths(const CheckCommand& arguments, bool are_asked);

/// How narrow depths are asked for. What is no number above 0 is warned of, and left out.
DepthOptions depth_options(const CheckArguments& arguments, std::vector<std::string>& warnings);

/// What is asked but for rules, depths and all else that `question_of` adds.
CheckQuestion check_question(const CheckArguments& arguments, bool faces, const ClearanceQuestion& clearances);

/// Rules are about the models' names. Adds warnings.
CheckQuestion question_of(const CheckCommand& arguments, LoadedScene& loaded, std::span<const SceneInstance> models,
                          const DepthOptions& depth);

/// Whether a reported pair makes the check fail. What may overlap, for all that could be decided, counts as if it did.
bool is_failure(const ReportedPair& pair, FailOn fail_on);

/// The exit code of a check that was stopped, whatever it found.
inline constexpr int unfinished_code = 3;

int code_of(const CheckReport& report, FailOn fail_on);

}  // namespace toccata::command
