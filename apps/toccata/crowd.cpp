#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "crowd_view.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "over_ranks.hpp"
#include "saved.hpp"
#include "subcommands.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/reports/crowd_report.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// Those that go through so many boxes in bearable time.
std::vector<BroadPhaseMethod> methods_for(std::size_t count) {
  std::vector<BroadPhaseMethod> methods;
  for (const BroadPhaseMethod method : broad_phase_methods()) {
    const bool is_for_few = method == BroadPhaseMethod::interval_sweeps || method == BroadPhaseMethod::rectangle_sweeps;
    if (is_for_few && count > 10'000) continue;
    if (method == BroadPhaseMethod::brute_force && count > 20'000) continue;
    if (method == BroadPhaseMethod::sort_and_sweep && count > 300'000) continue;
    methods.push_back(method);
  }
  return methods;
}

/// `arguments.bounds` is one of their names.
CrowdBounds bounds_of(const CrowdArguments& arguments) {
  const auto is_named = [&](CrowdBounds bounds) { return name_of(bounds) == arguments.bounds; };
  return *std::find_if(all_crowd_bounds.begin(), all_crowd_bounds.end(), is_named);
}

SceneQuestion question_of(const CrowdArguments& arguments) {
  if (arguments.world)
    return CrowdWorldQuestion{arguments.count, arguments.frames,  broad_phase_method(arguments.method),
                              arguments.seed,  arguments.threads, arguments.bodies};
  return CrowdQuestion{
      arguments.scene,
      arguments.count,
      arguments.frames,
      arguments.compare ? methods_for(arguments.count) : std::vector{broad_phase_method(arguments.method)},
      arguments.seed,
      arguments.threads,
      bounds_of(arguments)};
}

/// All that is asked is in the case.
int run_case(const CrowdArguments& arguments) {
  const CaseUse use{.asks = "crowd", .needs_options = true};
  if (const auto code = answered_case(arguments, use)) return *code;
  throw Error(
      fmt::format("{} is no case of a crowd: crowds are made from a seed, and no other file is read. Leave it out",
                  arguments.input.files.front()));
}

int run_crowd(const CrowdArguments& arguments) {
  if (!arguments.input.files.empty()) return run_case(arguments);
  const SceneQuestion question = question_of(arguments);
  const CrowdView view(arguments, question);
  const CheckInput input = about_no_file();
  const SceneAnswer answer = ask_for(input, question, arguments, {arguments.world ? "steps" : "frames"});
  const std::string written = view.write();
  print_answer(input, question, answer, arguments, [&](const SceneAnswer& found) {
    return std::visit([&](const auto& report) { return table_of(input, report); }, found) + written;
  });
  return 0;
}

/// What a case of a crowd says itself.
std::vector<CLI::Option*> add_flight(CLI::App& app, CrowdArguments& crowd) {
  std::vector<std::string> methods;
  for (const BroadPhaseMethod method : broad_phase_methods()) methods.emplace_back(name_of(method));
  const auto positive = whole_number(1, 100'000'000);
  return {
      app.add_option("--count", crowd.count, "boxes or bodies")->check(positive)->capture_default_str(),
      app.add_option("--frames", crowd.frames, "the median of their times is told")
          ->check(positive)
          ->capture_default_str(),
      app.add_option("--seed", crowd.seed, "another seed, another crowd")->check(whole_number())->capture_default_str(),
      add_threads(app, crowd.threads, "pairs")->capture_default_str(),
      app.add_option("--method", crowd.method, "how pairs are found")
          ->check(CLI::IsMember(methods))
          ->capture_default_str()};
}

/// What bodies in a World do.
CLI::Option* add_bodies(CLI::App& app, CrowdArguments& crowd) {
  std::vector<std::string> scenes;
  for (const NamedScene& scene : body_crowd_scenes()) scenes.push_back(scene.name);
  return app
      .add_option(
          "--bodies", crowd.bodies,
          "what they do in the World: fly in a room, stand in stacks and roll between them, lie in a pile, fall "
          "on a floor or on the triangles of a terrain")
      ->check(CLI::IsMember(scenes))
      ->capture_default_str();
}

/// What bodies in a World do not have.
std::vector<CLI::Option*> add_boxes(CLI::App& app, CrowdArguments& crowd) {
  std::vector<std::string> scenes, bounds;
  for (const NamedScene& scene : crowd_scenes()) scenes.push_back(scene.name);
  for (const CrowdBounds one : all_crowd_bounds) bounds.emplace_back(name_of(one));
  return {app.add_option("--scene", crowd.scene, "how they lie and move")
              ->check(CLI::IsMember(scenes))
              ->capture_default_str(),
          app.add_option("--bounds", crowd.bounds,
                         "what bounds each: its box, the ball around that, or the box turned (oriented)")
              ->check(CLI::IsMember(bounds))
              ->capture_default_str(),
          app.add_option("--cells", crowd.cells,
                         "which cells the page shows: those of the method, or of a grid those that boxes enter, keep "
                         "and leave")
              ->check(CLI::IsMember({"method", "tracked"}))
              ->capture_default_str()};
}

}  // namespace

std::string crowd_words(const CrowdQuestion& question) {
  if (question.bounds == CrowdBounds::balls) return counted(question.count, "ball");
  if (question.bounds == CrowdBounds::oriented) return counted(question.count, "oriented box", "oriented boxes");
  return counted(question.count, "box", "boxes");
}

std::string crowd_words(const CrowdWorldQuestion& question) {
  const std::string bodies = counted(question.count, "body", "bodies");
  if (question.scene != "fly") return fmt::format("{} ({})", bodies, question.scene);
  return bodies + (question.count == 1 ? " that flies" : " that fly");
}

std::string table_of(const CheckInput&, const CrowdReport& report) {
  const CrowdQuestion& question = report.question;
  std::string text = fmt::format("{}, {}, {}\n{:<20}{:>13}{:>11}{:>11}{:>10}{:>10}{:>9}\n", crowd_words(question),
                                 question.scene, counted(question.frames, "frame"), "method", "ms per frame", "worst",
                                 "pairs", "begin", "end", "B/body");
  for (const CrowdRun& run : report.runs)
    text +=
        fmt::format("{:<20}{:>13.3f}{:>11.3f}{:>11}{:>10}{:>10}{:>9.0f}\n", name_of(run.method), run.frames.median_ms(),
                    run.frames.worst_ms(), run.pairs(), run.begin, run.end, run.bytes_per_body);
  for (const CrowdRun& run : report.runs)
    if (!run.reason.empty()) text += fmt::format("{}: {}\n", name_of(run.method), run.reason);
  return text;
}

Summary summary_of(const CrowdReport& report) {
  return {fmt::format("{} in {}", crowd_words(report.question), counted(report.question.frames, "frame"))};
}

std::string table_of(const CheckInput&, const CrowdWorldReport& report) {
  const CrowdWorldQuestion& question = report.question;
  return fmt::format("{}, {}\n{:<20}{:>12}{:>11}{:>11}{:>10}{:>9}\n{:<20}{:>12.3f}{:>11.3f}{:>11}{:>10}{:>9}\n",
                     crowd_words(question), counted(question.frames, "frame"), "broad phase", "ms per step", "worst",
                     "in contact", "begin", "end", name_of(report.used), report.frames.median_ms(),
                     report.frames.worst_ms(), report.pairs(), report.begin, report.end);
}

Summary summary_of(const CrowdWorldReport& report) {
  return {fmt::format("{} in {}", crowd_words(report.question), counted(report.question.frames, "step"))};
}

Subcommand add_crowd(CLI::App& app) {
  const auto arguments = std::make_shared<CrowdArguments>();
  CLI::App* crowd = app.add_subcommand("crowd", "many moving boxes: which overlap, frame by frame, and how fast");
  CLI::Option* files =
      crowd->add_option("case", arguments->input.files, "a case of a crowd, to be answered again")->expected(0, 1);
  const std::vector<CLI::Option*> flight = add_flight(*crowd, *arguments), boxes = add_boxes(*crowd, *arguments);
  CLI::Option* compare =
      crowd->add_flag("--compare", arguments->compare, "all methods that can bear so many, one after the other");
  compare->excludes(flight.back());
  CLI::Option* world =
      crowd->add_flag("--world", arguments->world,
                      "instead of boxes, spheres, boxes, capsules and hulls in a World: which are in contact, exactly");
  world->excludes(compare);
  add_bodies(*crowd, *arguments)->needs(world)->excludes(files);
  for (CLI::Option* option : boxes) world->excludes(option->excludes(files));
  for (CLI::Option* option : flight) option->excludes(files);
  compare->excludes(files);
  world->excludes(files);
  add_file(*crowd, "--html", arguments->html,
           "also write a page of the boxes, their pairs and the method's cells, frame by frame", "FILE.html");
  add_picture(*crowd, *arguments);
  add_glb(*crowd, *arguments);
  add_save_case(
      *crowd, arguments->save_case,
      "write the question and the answer into one file; `replay` asks it again (docs/reference/case-file.md)");
  add_json(*crowd, arguments->format, "write JSON (docs/reference/crowd.md)");
  add_distributed(*crowd);
  crowd->footer(
      with_name("Exit code: 0, or 2 for trouble; of a case also 1, where its answer is another.\n\n"
                "Example:\n  {0} crowd --count 100000 --scene clustered\n  {0} crowd --count 5000 --compare\n"
                "  {0} crowd --count 2000 --frames 100 --html crowd.html\n"
                "  {0} crowd --world --count 500 --frames 60 --html world.html --save-case world.json\n"
                "  {0} crowd --world --bodies terrain --count 300 --frames 100 --html terrain.html\n"
                "  {0} crowd world.json --glb world.glb\n"
                "  mpirun -np 2 {0} crowd --count 1000000 --distributed"));
  return {crowd, [arguments] { return run_crowd(*arguments); }};
}

}  // namespace toccata::command
