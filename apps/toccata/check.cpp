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
#include "check_command.hpp"
#include "check_input.hpp"
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
       "--self asks where each object intersects itself as a surface, and not about pairs"},
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

/// Where nothing but lines is written, pairs are judged as they are, and not kept: memory does not follow them.
Asking asking_of(const CheckCommand& arguments, bool& is_failing) {
  Asking asking{"checking", is_drawn(arguments), {}};
  const bool are_lines_alone =
      arguments.format == Format::stream && !asking.is_drawn && arguments.exchange.overlap_bodies.empty();
  if (are_lines_alone)
    asking.streamed = [&](const ReportedPair& pair) { is_failing = is_failing || is_failure(pair, arguments.fail_on); };
  return asking;
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
  std::vector<std::string> left_out;
  const DepthOptions depth = depth_options(arguments, left_out);
  warn_at_once(loaded, left_out);
  const CheckQuestion question = question_of(arguments, loaded, input.models, depth);
  bool is_failing = false;
  SceneAnswer answer = ask_for(input, question, arguments, asking_of(arguments, is_failing));
  warn_of_unfinished(input.loaded, std::get<CheckReport>(answer));
  const int code = std::max(code_of(std::get<CheckReport>(answer), arguments.fail_on), is_failing ? 1 : 0);
  give_answer(question, input, answer, arguments, exchange_of(arguments, was_stopped));
  return was_stopped ? unfinished_code : code;
}

}  // namespace

std::string table_of(const CheckInput& input, const CheckReport& report) {
  return check_table(input.loaded.scene, report) + scaling_line(input.loaded);
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
                                 counted(triangle_count(table_objects(scene)), "triangle"));
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
  add_pair_questions(check, arguments);
  check.add_flag("--self", arguments.self,
                 "each object against itself, instead of against the others: where its own faces meet");
  check.add_flag("--faces", arguments.faces,
                 "list the faces that meet, by the files' own numbers from 0; with --poses, count them");
}

/// Takes the words in, and throws Error where they exclude each other.
void take_all_words(CheckCommand& arguments) {
  arguments.by_winding = arguments.solid_word == "by-winding";
  if (arguments.by_winding && (arguments.format == Format::stream || !arguments.poses.empty()))
    throw Error(fmt::format(
        "--solid by-winding excludes {}: what is inside an open mesh is looked for after all pairs of the scene; "
        "give one of the two",
        arguments.poses.empty() ? "--stream" : "--poses"));
  if (arguments.by_winding) arguments.solid_word = "auto";
  take_words(arguments);
  take_choices(arguments);
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
            take_all_words(*arguments);
            return run_check(*arguments, asking_options(*check));
          }};
}

}  // namespace toccata::command
