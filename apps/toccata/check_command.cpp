#include "check_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "load.hpp"
#include "option_kinds.hpp"
#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {

void add_pair_questions(CLI::App& check, CheckCommand& arguments) {
  check.add_option("--touching", arguments.touching_word, "whether merely touching counts, also with a clearance")
      ->check(CLI::IsMember({"count", "ignore"}))
      ->capture_default_str();
  check.add_flag("--penetration", arguments.penetration,
                 "how deep solids overlap, a way to part them, their regions of contact and (without --poses) their "
                 "points of contact");
  add_text(check, "--precision", arguments.precision_word,
           "how wide the bracket of a depth may be, of --penetration or --tolerance: upper at most 1 + so many times "
           "lower (0.1)",
           "a number must be given")
      ->type_name("NUMBER");
  add_text(check, "--time-per-depth", arguments.time_per_depth_word,
           "seconds for the depth of each pair: then the bracket so far is told (none)", "seconds must be given")
      ->type_name("SECONDS");
  check.add_flag(
      "--volume", arguments.volume,
      "how much volume solids have in common, between bounds; the kind of clash (protrude, pierce, contains, "
      "equal), and which pierces; and a point of both");
}

void add_rules_of_clashes(CLI::App& check, CheckCommand& arguments) {
  add_length(check, "--tolerance", arguments.tolerance,
             "overlaps that are certainly no deeper are told apart and are no clash (0.1mm); in a file of --rules also "
             "of some pairs");
  add_clearances(check, arguments);
  add_rules(check, arguments.rules);
  add_file(check, "--baseline", arguments.baseline,
           "an earlier report of --json: which pairs are new since, graver, known, moved or gone", "REPORT.json");
}

void add_order(CLI::App& check, CheckCommand& arguments) {
  check
      .add_option(
          "--fail-on", arguments.fail_on_word,
          "exit code 1 for any pair that is told, only for hard ones, which do more than touch or come near, or "
          "only for what is new or graver than in the baseline (grown, too, where --penetration or --volume is asked "
          "both "
          "times)")
      ->check(CLI::IsMember({"any", "hard", "new"}))
      ->capture_default_str();
  check
      .add_option("--sort", arguments.order_word,
                  "the order of the pairs: that of the objects, or first what overlaps, the deepest of it first where "
                  "--penetration is asked, then what touches, then what is near")
      ->check(CLI::IsMember({"objects", "severity"}))
      ->capture_default_str();
  check
      .add_option("--group", arguments.group_word,
                  "which clashes belong together: those of one part, or those in places next to each other")
      ->check(CLI::IsMember({"none", "part", "region"}))
      ->capture_default_str();
}

void take_choices(CheckCommand& arguments) {
  if (arguments.fail_on_word == "new" && arguments.baseline.empty())
    throw Error("--fail-on new tells what is new from what a baseline knows: add --baseline with an earlier report");
  arguments.touching = arguments.touching_word == "ignore" ? Touching::ignore : Touching::count;
  if (arguments.order_word == "severity") arguments.order = PairOrder::severity;
  if (arguments.group_word != "none")
    arguments.grouping = arguments.group_word == "part" ? ClashGrouping::part : ClashGrouping::region;
  if (arguments.fail_on_word != "any")
    arguments.fail_on = arguments.fail_on_word == "hard" ? FailOn::hard : FailOn::added;
}

void require_depths(const CheckCommand& arguments, bool are_asked) {
  if (are_asked) return;
  for (const auto& [name, word] : {std::pair("--precision", &arguments.precision_word),
                                   std::pair("--time-per-depth", &arguments.time_per_depth_word)})
    if (!word->empty())
      throw Error(fmt::format("{} is about depths, which are not asked for: add --penetration or --tolerance", name));
}

CheckQuestion question_of(const CheckCommand& arguments, LoadedScene& loaded, std::span<const SceneInstance> models,
                          const DepthOptions& depth) {
  CheckQuestion question = check_question(arguments, arguments.faces, read_clearances(arguments, loaded.scene));
  question.depth = depth;
  const LengthUnits units = length_units(loaded.scene, arguments.input);
  question.rules = read_rules(arguments.rules, models, units, loaded.warnings);
  question.volume = arguments.volume;
  if (!arguments.tolerance.empty())
    question.tolerance = read_length("--tolerance", arguments.tolerance, units, Longest::finite);
  question.grouping = arguments.grouping;
  if (!arguments.baseline.empty()) question.baseline = read_baseline(arguments.baseline, loaded.scene);
  question.order = arguments.order;
  question.by_winding = arguments.by_winding;
  require_depths(arguments, question.penetration || question.tolerance || !question.rules.tolerances.empty());
  return question;
}

DepthOptions depth_options(const CheckArguments& arguments, std::vector<std::string>& warnings) {
  DepthOptions depth = CheckOptions{}.depth;
  const auto take = [&](const std::string& word, const char* name, double& number, const std::string& instead) {
    double given = 0;
    const char* const end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, given);
    if (error == std::errc{} && rest == end && given > 0 && std::isfinite(given))
      number = given;
    else if (!word.empty())
      warnings.push_back(
          fmt::format("{} {} is not a finite number above 0: answered {}", name, printable(word), instead));
  };
  take(arguments.precision_word, "--precision", depth.precision, fmt::format("with {}", depth.precision));
  take(arguments.time_per_depth_word, "--time-per-depth", depth.time_limit, "without a limit");
  return depth;
}

CheckQuestion check_question(const CheckArguments& arguments, bool faces, const ClearanceQuestion& clearances) {
  CheckQuestion question;
  question.touching = arguments.touching;
  question.faces = faces;
  question.penetration = arguments.penetration;
  question.clearance = clearances.common;
  question.pair_clearances = clearances.of_pairs;
  return question;
}

bool is_failure(const ReportedPair& pair, FailOn fail_on) {
  if (!is_clash(pair)) return false;
  switch (fail_on) {
    case FailOn::any:
      return true;
    case FailOn::hard:
      return counts_as_contact(pair.relation, Touching::ignore);
    case FailOn::added:
      return since_baseline(pair) == Since::added || since_baseline(pair) == Since::graver;
  }
  return true;
}

int code_of(const CheckReport& report, FailOn fail_on) {
  if (report.unfinished > 0) return unfinished_code;
  const auto fails = [&](const ReportedPair& pair) { return is_failure(pair, fail_on); };
  return std::any_of(report.pairs.begin(), report.pairs.end(), fails) ? 1 : 0;
}

}  // namespace toccata::command
