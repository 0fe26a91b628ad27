#include "case_asked.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "ask.hpp"
#include "check_input.hpp"
#include "file_text.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/case_file.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// The case in the only file, where that is one: cheaply, as most are none.
std::optional<Case> case_in(const std::vector<std::string>& files) {
  if (files.size() != 1 || !is_json(files[0])) return std::nullopt;
  if (text_of_file(files[0]).find("\"query\"") == std::string::npos) return std::nullopt;
  Case content = read_case(files[0]);
  return content.question ? std::optional(std::move(content)) : std::nullopt;
}

int answer(const Case& content, const PosedArguments& arguments, const AlsoWritten& also) {
  require_view(arguments);
  CheckInput input = read_check_input(arguments);
  SceneAnswer now = ask_for(input, *content.question, arguments, {"asking", draws_something(target_of(arguments))});
  const std::string difference =
      content.answer.empty() ? "" : answer_difference(content.answer, json_as_asked(input, *content.question, now));
  if (!difference.empty())
    input.loaded.warnings.push_back(fmt::format("this is another answer than the one that {} holds, first at {}",
                                                arguments.input.files[0], difference));
  give_answer(*content.question, input, now, arguments, also);
  return difference.empty() ? exit_code_of(now) : 1;
}

std::string command_of(const CaseUse& use) { return use.command.empty() ? use.asks : use.command; }

bool is_question_of(const std::string& question, const std::string& subcommand) {
  return question == subcommand || question.starts_with(subcommand + "-");
}

}  // namespace

bool names_case(const std::vector<std::string>& files) { return case_in(files).has_value(); }

int exit_code_of(const SceneAnswer& answer) {
  return std::visit([](const auto& report) { return summary_of(report).is_found ? 1 : 0; }, answer);
}

bool changes_objects(const PosedArguments& arguments) {
  const InputArguments& input = arguments.input;
  return arguments.solid || input.scale != 1 || !input.unit.empty() || !input.close.empty() || arguments.pose_a ||
         arguments.pose_b || !arguments.poses.empty();
}

std::optional<int> answered_case(const PosedArguments& arguments, const CaseUse& use, const AlsoWritten& also) {
  const std::optional<Case> content = case_in(arguments.input.files);
  if (!content) return std::nullopt;
  const std::string asked = name_of(*content->question), file = arguments.input.files[0];
  const bool is_own = use.takes_any || is_question_of(asked, use.asks);
  const bool asks_itself = use.asks_itself || !use.asking.empty();
  if (!asks_itself && is_own) return answer(*content, arguments, also);
  const std::string advice =
      fmt::format("`{} {} {}` answers it", called_as(), is_own ? command_of(use) : "check", file);
  if (!asks_itself && use.needs_options)
    throw Error(
        fmt::format("{} holds a question, {}: {}; to ask another about its scene, say which", file, asked, advice));
  const std::string why = use.asking.empty() ? "" : fmt::format(", as {} asks another", fmt::join(use.asking, " "));
  print_warnings({fmt::format("{} holds a question, {}, which is not asked here{}: {}", file, asked, why, advice)});
  return std::nullopt;
}

}  // namespace toccata::command
