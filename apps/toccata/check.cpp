#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <system_error>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "check_rules.hpp"
#include "check_table.hpp"
#include "clearance.hpp"
#include "early_end.hpp"
#include "exchange.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "over_ranks.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/reports/scene_question.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// What counts as found, for the exit code.
enum class FailOn { any, hard, added };

/// With what only `check` has of options.
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

/// Options that have nothing to do with each other, and why.
struct Refusal {
  const char* option;
  std::vector<const char*> others;
  const char* why;
};

const std::vector<Refusal>& refusals() {
  static const std::vector<Refusal> all = {
      {"--self",
       {"--poses",  "--penetration", "--clearance", "--clearance-of",   "--solid",         "--touching",
        "--rules",  "--ignore",      "--between",   "--baseline",       "--sort",          "--fail-on",
        "--junit",  "--sarif",       "--bcf",       "--overlap-bodies", "--stream",        "--stop-after",
        "--volume", "--tolerance",   "--group",     "--precision",      "--time-per-depth"},
       "--self asks where each object meets itself as a surface, and not about pairs"},
      {"--poses",
       {"--clearance", "--clearance-of", "--rules", "--ignore", "--between", "--baseline", "--sort", "--junit",
        "--sarif", "--bcf", "--overlap-bodies", "--stream", "--stop-after", "--volume", "--tolerance", "--group"},
       "--poses asks about two objects at many poses, and not about the pairs of a scene"},
      {"--stream",
       {"--json", "--csv", "--baseline", "--sort", "--group", "--save-case"},
       "--stream tells pairs as they are found, each for itself, before all are known"},
  };
  return all;
}

/// Throws Error naming both options and the reason.
void require_company(const CLI::App& app) {
  for (const Refusal& refusal : refusals())
    for (const char* other : refusal.others)
      if (app.count(refusal.option) > 0 && app.count(other) > 0)
        throw Error(fmt::format("{0} excludes {1}: {2}; give one of the two", refusal.option, other, refusal.why));
}

/// Whether a reported pair makes the check fail. What may overlap, for all that could be decided, counts as if it did.
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

/// The exit code of a check that was stopped, whatever it found.
constexpr int unfinished_code = 3;

int code_of(const CheckReport& report, FailOn fail_on) {
  if (report.unfinished > 0) return unfinished_code;
  const auto fails = [&](const ReportedPair& pair) { return is_failure(pair, fail_on); };
  return std::any_of(report.pairs.begin(), report.pairs.end(), fails) ? 1 : 0;
}

/// Throws Error where options are about depths, and nothing asks for them.
void require_depths(const CheckCommand& arguments, bool are_asked) {
  if (are_asked) return;
  for (const auto& [name, word] : {std::pair("--precision", &arguments.precision_word),
                                   std::pair("--time-per-depth", &arguments.time_per_depth_word)})
    if (!word->empty())
      throw Error(fmt::format("{} is about depths, which are not asked for: add --penetration or --tolerance", name));
}

int run_check_poses(const CheckCommand& arguments) {
  require_view(arguments);
  CheckInput input = read_check_input(arguments);
  warn_of_open_meshes(input, arguments.threads);
  std::vector<std::string> left_out;
  const CheckPosesQuestion question{read_queries(input, arguments), arguments.touching, arguments.faces,
                                    arguments.penetration, depth_options(arguments, left_out)};
  warn_at_once(input.loaded, left_out);
  const SceneAnswer answer = answer_to(question, input, arguments, "checking");
  if (arguments.fail_on == FailOn::any) return exit_code_of(answer);
  const std::vector<Relation>& relations = std::get<PosesReport>(answer).relations;
  const auto is_hard = [](const Relation& relation) { return counts_as_contact(relation, Touching::ignore); };
  return std::any_of(relations.begin(), relations.end(), is_hard) ? 1 : 0;
}

int run_check_self(const CheckArguments& arguments) {
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  const SelfQuestion question{arguments.faces};
  return exit_code_of(answer_to(question, input, arguments, "checking"));
}

CheckQuestion question_of(const CheckCommand& arguments, CheckInput& input) {
  LoadedScene& loaded = input.loaded;
  CheckQuestion question = check_question(arguments, arguments.faces, read_clearances(arguments, loaded.scene));
  std::vector<std::string> left_out;
  question.depth = depth_options(arguments, left_out);
  warn_at_once(loaded, left_out);
  const LengthUnits units = length_units(loaded.scene, arguments.input);
  question.rules = read_rules(arguments.rules, input.models, units, loaded.warnings);
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

void warn_of_unfinished(LoadedScene& loaded, const CheckReport& report) {
  if (report.unfinished == 0) return;
  loaded.warnings.push_back(
      fmt::format("the check was stopped {}: {} of {} were not looked at, and what is told is not all",
                  was_interrupted() ? "as it was interrupted" : "at its time limit", grouped(report.unfinished),
                  counted(report.candidate_pairs, "pair")));
}

/// Writes what other programs read of the answer, and says whether that was stopped before it was all.
AlsoWritten exchange_of(const CheckCommand& arguments, bool& was_stopped) {
  return [&arguments, &was_stopped](const CheckInput& input, const SceneAnswer& answer) {
    ExchangeTold told = write_exchange(input, answer, arguments,
                                       [&](const ReportedPair& pair) { return is_failure(pair, arguments.fail_on); });
    was_stopped = told.was_stopped;
    return std::move(told.lines);
  };
}

int run_check(const CheckCommand& arguments, const std::vector<std::string>& asking) {
  require_exchange(arguments);
  bool was_stopped = false;
  const bool asks_itself =
      arguments.self || arguments.faces || arguments.penetration || arguments.touching != Touching::count ||
      !arguments.clearance.empty() || !arguments.clearances_of.empty() || has_rules(arguments.rules) ||
      !arguments.baseline.empty() || arguments.order != PairOrder::objects ||
      arguments.grouping != ClashGrouping::none || arguments.volume || !arguments.tolerance.empty() ||
      !arguments.precision_word.empty() || !arguments.time_per_depth_word.empty() || arguments.fail_on != FailOn::any ||
      changes_objects(arguments);
  if (const auto code = answered_case(arguments,
                                      {.asks = "check",
                                       .asks_itself = asks_itself,
                                       .takes_any = true,
                                       .asking = asks_itself ? asking : std::vector<std::string>{}},
                                      exchange_of(arguments, was_stopped)))
    return was_stopped ? unfinished_code : *code;
  // Whether a file of rules tells a tolerance is seen when it is read.
  require_depths(arguments, arguments.penetration || !arguments.tolerance.empty() || !arguments.rules.files.empty());
  if (!arguments.poses.empty()) return run_check_poses(arguments);
  if (arguments.self) return run_check_self(arguments);
  require_view(arguments);
  CheckInput input = read_check_input(arguments);
  LoadedScene& loaded = input.loaded;
  if (loaded.scene.objects.size() < 2)
    throw Error(
        fmt::format("{} holds one object; a check needs two: name another file or a scene with more objects, "
                    "say --split where the file has several parts in it, or --self to check it against itself",
                    arguments.input.files.front()));
  warn_of_open_meshes(input, arguments.threads, arguments.by_winding ? OpenMeshes::by_winding : OpenMeshes::surfaces);
  const CheckQuestion question = question_of(arguments, input);
  SceneAnswer answer = ask_for(input, question, arguments, {"checking", is_drawn(arguments)});
  warn_of_unfinished(input.loaded, std::get<CheckReport>(answer));
  const int code = code_of(std::get<CheckReport>(answer), arguments.fail_on);
  give_answer(question, input, answer, arguments, exchange_of(arguments, was_stopped));
  return was_stopped ? unfinished_code : code;
}

}  // namespace

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

std::string table_of(const CheckInput& input, const CheckReport& report) {
  std::string text = check_table(input.loaded.scene, report);
  if (!input.loaded.scaled_by.empty())
    text += fmt::format(
        "Coordinates were multiplied by {} and rounded: slanted faces that touch in the files may be apart or overlap "
        "by a last digit.\n",
        input.loaded.scaled_by);
  return text;
}

Summary summary_of(const CheckReport& report) {
  return {counted(report.pairs.size(), "pair"), std::any_of(report.pairs.begin(), report.pairs.end(), is_clash)};
}

std::string table_of(const CheckInput& input, const PosesReport& report) {
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.relations.size(); ++i) {
    const Relation& relation = report.relations[i];
    rows.push_back({fmt::format("query {}", i), names[0], verb_of(relation), names[1], remark_on(relation)});
    const bool has_depth = relation.kind != RelationKind::apart;
    if (!report.penetrations.empty())
      rows.back().push_back(has_depth ? depth_text(report.penetrations[i], report.depth_ends[i], names[1]) : "");
    if (!report.counts.empty()) rows.back().push_back(counted(report.counts[i].face_pairs, "pair") + " of faces");
  }
  const std::size_t contacts = contact_count(report);
  const auto touching = static_cast<std::size_t>(
      std::count_if(report.relations.begin(), report.relations.end(),
                    [](const Relation& relation) { return relation.kind != RelationKind::apart; }));
  const auto undecided = static_cast<std::size_t>(
      std::count_if(report.relations.begin(), report.relations.end(), [](const Relation& relation) {
        return relation.kind == RelationKind::touching && relation.status != Status::exact;
      }));
  std::string text = columns(rows, 2) + fmt::format("{} of {} in contact, {}.\n", grouped(contacts),
                                                    counted(rows.size(), "query", "queries"), decided_text(undecided));
  if (touching > contacts) text += fmt::format("{} merely touching, ignored as asked.\n", grouped(touching - contacts));
  return text;
}

Summary summary_of(const PosesReport& report) {
  return {counted(report.queries.size(), "pose"), contact_count(report) > 0};
}

std::string table_of(const CheckInput& input, const SelfReport& report) {
  const Scene& scene = input.loaded.scene;
  const std::vector<std::string> names = table_names(scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.objects.size(); ++i) {
    const std::size_t pairs = report.objects[i].face_pairs;
    rows.push_back({names[i], pairs == 0 ? "does not intersect itself"
                                         : fmt::format("self-intersects in {} of faces", counted(pairs, "pair"))});
  }
  const std::size_t intersection = self_intersecting_count(report);
  const std::string last = intersection == 0 ? "Nothing intersects itself, decided exactly.\n"
                                             : fmt::format("{} {}, decided exactly.\n", counted(intersection, "object"),
                                                           intersection == 1 ? "self-intersects" : "self-intersect");
  std::string text = fmt::format("{} with {}, each against itself.\n", counted(rows.size(), "object"),
                                 counted(triangle_count(scene), "triangle"));
  if (!report.has_faces) return text + columns(rows, 2) + last;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += columns({rows[i]}, 2);
    if (!report.objects[i].faces.empty()) text += face_lines(report.objects[i].faces);
  }
  return text + last;
}

Summary summary_of(const SelfReport& report) {
  const std::size_t count = self_intersecting_count(report);
  return {counted(count, "object") + " self-intersecting", count > 0};
}

namespace {

/// What is asked about the pairs.
void add_questions(CLI::App& check, CheckCommand& arguments) {
  check
      .add_option("--solid", arguments.solid_word,
                  "auto: watertight meshes are solids; all: an open mesh is an error; none: all are surfaces; "
                  "by-winding: as auto, and what lies inside an open mesh by its generalised winding number overlaps "
                  "it, undecided (default: as the scene says, else auto)")
      ->check(CLI::IsMember({"auto", "all", "none", "by-winding"}));
  add_close(check, arguments.input);
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
  check.add_flag("--volume", arguments.volume,
                 "how much volume solids have in common, between bounds; whether one passes through the other; and a "
                 "point of both");
  check.add_flag("--self", arguments.self,
                 "each object against itself, instead of against the others: where its own faces meet");
  check.add_flag("--faces", arguments.faces,
                 "list the faces that meet, by the files' own numbers from 0; with --poses, count them");
}

/// Which pairs are told, and which of them are clashes.
void add_rules_of_clashes(CLI::App& check, CheckCommand& arguments) {
  add_length(check, "--tolerance", arguments.tolerance,
             "overlaps that are certainly no deeper are told apart and are no clash (0.1mm); in a file of --rules also "
             "of some pairs");
  add_clearances(check, arguments);
  add_rules(check, arguments.rules);
  add_file(check, "--baseline", arguments.baseline,
           "an earlier report of --json: which pairs are new since, graver, known, moved or gone", "REPORT.json");
}

/// What fails, and how the pairs are ordered.
void add_order(CLI::App& check, CheckCommand& arguments) {
  check
      .add_option(
          "--fail-on", arguments.fail_on_word,
          "exit code 1 for any pair that is told, only for hard ones, which do more than touch or come near, or "
          "only for what is new or graver than in the baseline")
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

/// Takes the words in, and throws Error where they exclude each other.
void take_choices(CheckCommand& arguments) {
  if (arguments.fail_on_word == "new" && arguments.baseline.empty())
    throw Error("--fail-on new tells what is new from what a baseline knows: add --baseline with an earlier report");
  arguments.by_winding = arguments.solid_word == "by-winding";
  if (arguments.by_winding && (arguments.format == Format::stream || !arguments.poses.empty()))
    throw Error(fmt::format(
        "--solid by-winding excludes {}: what is inside an open mesh is looked for after all pairs of the scene; "
        "give one of the two",
        arguments.poses.empty() ? "--stream" : "--poses"));
  if (arguments.by_winding) arguments.solid_word = "auto";
  take_words(arguments);
  arguments.touching = arguments.touching_word == "ignore" ? Touching::ignore : Touching::count;
  if (arguments.order_word == "severity") arguments.order = PairOrder::severity;
  if (arguments.group_word != "none")
    arguments.grouping = arguments.group_word == "part" ? ClashGrouping::part : ClashGrouping::region;
  if (arguments.fail_on_word != "any")
    arguments.fail_on = arguments.fail_on_word == "hard" ? FailOn::hard : FailOn::added;
}

}  // namespace

Subcommand add_check(CLI::App& app) {
  const auto arguments = std::make_shared<CheckCommand>();
  CLI::App* check = app.add_subcommand("check", "which objects touch, decided exactly");
  add_input(*check, arguments->input, any_files);
  add_poses(*check, *arguments);
  add_questions(*check, *arguments);
  add_rules_of_clashes(*check, *arguments);
  add_order(*check, *arguments);
  add_writing(*check, *arguments, "docs/reference/check-report.md");
  add_exchange(*check, arguments->exchange);
  add_distributed(*check);
  check->add_flag_callback(
      "--stream", [arguments] { arguments->format = Format::stream; },
      "write JSON lines, each pair as soon as it is found, and a last line that says whether these are all");
  check
      ->add_option("--stop-after", arguments->stop_after,
                   "seconds for the whole run: then what is found is told, and how many pairs are left (none)")
      ->check(number_above_0())
      ->type_name("SECONDS");
  check->footer(
      with_name("Exit code: 0 nothing touches or is nearer than its clearance, 1 something is (--fail-on says what "
                "counts), 2 trouble, 3 stopped by "
                "--stop-after or Ctrl-C before all pairs were looked at.\n\n"
                "Example:\n"
                "  {0} demo --write scenes\n"
                "  {0} check scenes/a.obj scenes/b.stl --faces\n"
                "  {0} check part.stl part.stl --pose-b 1 0 0  0 1 0  0 0 1  0.5 0 0\n"
                "  {0} check robot.stl table.obj --poses path.txt --csv\n"
                "  {0} check part.stl --self --faces\n"
                "  {0} check shapes.json --penetration\n"
                "  {0} check cell.json --clearance 2mm --clearance-of robot,table=5cm\n"
                "  {0} check assembly.glb --tolerance 0.1mm --touching ignore --volume --group part\n"
                "  {0} check assembly.glb --rules rules.txt --ignore 'bolt*,nut*' --touching ignore\n"
                "  {0} check assembly.glb --baseline yesterday.json --fail-on new --sort severity --json\n"
                "  {0} check a.stl b.stl --html report.html\n"
                "  mpirun -np 4 {0} check hall.glb pipes.glb --distributed --json\n"
                "  {0} check scenes/shelf/scene.json --json"));
  return {check, [arguments, check] {
            require_company(*check);
            take_choices(*arguments);
            return run_check(*arguments, asking_options(*check));
          }};
}

}  // namespace toccata::command
