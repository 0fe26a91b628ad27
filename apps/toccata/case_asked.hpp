#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "ask.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::command {

/// What a subcommand does with a case: a scene file that holds a question.
struct CaseUse {
  std::string asks;            ///< what the question of the subcommand is called: "distance" of "distance-poses", too
  bool asks_itself = false;    ///< the options ask something of the scene, whatever the case asks
  bool takes_any = false;      ///< the subcommand answers every question that a case may hold
  bool needs_options = false;  ///< without options it asks nothing
  std::string command{};       ///< by which it is asked, where that is not what it is called
  /// The options that do ask something of the scene, where the subcommand tells them.
  std::vector<std::string> asking{};
};

/// Where the arguments name one case, and it is for the subcommand to answer: asks its question, prints the answer, and
/// gives the exit code, which is that of the question's own subcommand, and 1 where the answer is another than the
/// recorded one. None where the subcommand asks its own question; that the case has another is a warning then. Throws
/// Error where it needs options for that, naming the command that answers the case.
std::optional<int> answered_case(const PosedArguments& arguments, const CaseUse& use, const AlsoWritten& also = {});

/// Whether the only file is a case.
[[nodiscard]] bool names_case(const std::vector<std::string>& files);

/// 1 where something was found that the subcommand looks for, else 0.
int exit_code_of(const SceneAnswer& answer);

/// The options say where the objects are, how large, or what they are taken for.
bool changes_objects(const PosedArguments& arguments);

}  // namespace toccata::command
