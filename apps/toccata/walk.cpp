#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "clearance.hpp"
#include "load.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/query_files.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// A length as it is written, and what it is where it is not, in metres.
struct WalkLength {
  const char* option;
  double metres;
  const char* help;
  std::string text{};
};

struct WalkArguments : PosedArguments {
  std::vector<std::string> from_words, to_words;
  std::string motion;  ///< a file; empty: to a place
  WalkLength radius{"--radius", 0.4, "of the capsule that walks (default: 0.4 m)"};
  WalkLength height{"--height", 1.8, "of it, in all (default: 1.8 m)"};
  WalkLength stride{"--stride", 0.1,
                    "how far it wants to go in a step, --to a point (default: 0.1 m, 3 m a second at 30 steps)"};
  WalkLength fall{"--fall", 0.01, "how much farther it falls in each step in the air than before (default: 0.01 m)"};
  WalkLength skin{"--skin", 0.01, "how far it stays from everything, up to its radius (default: 0.01 m)"};
  WalkLength step_height{"--step-height", 0.3, "the highest step that it walks up (default: 0.3 m)"};
  WalkLength snap{"--snap", 0.3, "how far below it ground is looked for (default: 0.3 m)"};
  double max_slope = 45;
  std::size_t most_steps = 10'000;
};

/// In units of the scene. Where that has none, a number of it is taken for metres.
double length_asked(const WalkLength& length, const Scene& scene) {
  if (!length.text.empty()) return read_length(length.option, length.text, {scene.unit}, Longest::finite);
  if (scene.unit == "unit") return length.metres;
  return read_length(length.option, fmt::format("{}m", length.metres), {scene.unit}, Longest::finite);
}

/// A skin that is wider than the walker would have it keep off from all that it walks between.
double skin_asked(const WalkArguments& arguments, const Scene& scene) {
  const double skin = length_asked(arguments.skin, scene), radius = length_asked(arguments.radius, scene);
  if (!(skin > 0 && skin <= radius))
    throw Error(
        fmt::format("the skin of the walker is {}, and has to be above 0 and no more than its radius, {}: say "
                    "another --skin or --radius",
                    skin, radius));
  return skin;
}

/// It stands on the origin of its frame.
Shape walker_asked(const WalkArguments& arguments, const Scene& scene, const Vec3& up) {
  const double radius = length_asked(arguments.radius, scene), height = length_asked(arguments.height, scene);
  if (!(radius > 0)) throw Error(fmt::format("--radius {}: a capsule has a radius above 0", arguments.radius.text));
  if (!(height >= 2 * radius))
    throw Error(
        fmt::format("a capsule of radius {} is at least {} high, and here it is {}: say another --height or "
                    "--radius",
                    radius, 2 * radius, height));
  return Capsule(radius * up, (height - radius) * up, radius);
}

void take_goal(WalkQuestion& question, const WalkArguments& arguments) {
  if (arguments.from_words.empty())
    throw Error("it is not said where the walk begins: name the point that it stands on with --from X Y Z");
  question.from = parse_point(arguments.from_words, "--from");
  if (!arguments.motion.empty()) {
    question.motions = read_points(arguments.motion);
  } else if (!arguments.to_words.empty()) {
    question.to = parse_point(arguments.to_words, "--to");
  } else {
    throw Error(
        "it is not said where the walk leads: name a point with --to X Y Z, or a file with a motion for each step with "
        "--motion");
  }
}

WalkQuestion walk_asked(const WalkArguments& arguments, const Scene& scene) {
  WalkQuestion question;
  question.options.up = up_of(arguments) == UpAxis::y ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  take_goal(question, arguments);
  question.walker = walker_asked(arguments, scene, question.options.up);
  question.stride = length_asked(arguments.stride, scene);
  // The motions of a file are all that is wanted, unless more is said.
  question.fall = arguments.motion.empty() || !arguments.fall.text.empty() ? length_asked(arguments.fall, scene) : 0;
  question.most_steps = arguments.most_steps;
  question.options.skin = skin_asked(arguments, scene);
  question.options.step_height = length_asked(arguments.step_height, scene);
  question.options.snap_distance = length_asked(arguments.snap, scene);
  question.options.max_slope_degrees = arguments.max_slope;
  return question;
}

/// Steps of a file are as they are.
void require_one_way(const CLI::App& walk) {
  for (const char* option : {"--stride", "--most-steps"})
    if (walk.count("--motion") > 0 && walk.count(option) > 0)
      throw Error(
          fmt::format("{} is about a walk --to a point; of --motion every line of the file is a step, as long as "
                      "it says: leave one of the two out",
                      option));
}

int run_walk(const WalkArguments& arguments, const std::vector<std::string>& asking) {
  if (const auto code = answered_case(arguments, {.asks = "walk", .needs_options = true, .asking = asking}))
    return *code;
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  return exit_code_of(answer_to(walk_asked(arguments, input.loaded.scene), input, arguments, "walking"));
}

/// What the walker had to do with an object.
struct ObjectWalked {
  std::size_t stood_on = 0, met = 0;  ///< in so many steps
  std::size_t first = 0;              ///< the step in which it first had

  void note(std::size_t& count, std::size_t step) {
    if (count == 0 && stood_on + met == 0) first = step;
    ++count;
  }
};

std::vector<ObjectWalked> objects_walked(const WalkReport& report, std::size_t count) {
  std::vector<ObjectWalked> objects(count);
  for (std::size_t i = 0; i < report.steps.size(); ++i) {
    const MoverStep<Index>& step = report.steps[i].step;
    if (const auto& ground = step.state.ground) objects[ground->object].note(objects[ground->object].stood_on, i + 1);
    std::vector<Index> met;
    for (const auto& contact : step.contacts) met.push_back(contact.object);
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    for (const Index object : met) objects[object].note(objects[object].met, i + 1);
  }
  return objects;
}

std::vector<std::string> row_of(const std::string& name, const ObjectWalked& object) {
  return {name, object.stood_on > 0 ? "stood on in " + counted(object.stood_on, "step") : "",
          object.met > 0 ? "met in " + counted(object.met, "step") : "", fmt::format("first in step {}", object.first)};
}

std::string end_text(const WalkReport& report) {
  switch (report.end) {
    case WalkOutcome::done:
      return "all motions are taken";
    case WalkOutcome::arrived:
      return "it arrives";
    case WalkOutcome::hindered:
      return "it gets no nearer to " + point_text(report.question.to);
    case WalkOutcome::fallen:
      return "it falls, and nothing is below it";
    case WalkOutcome::unfinished:
      break;
  }
  return "it is still on its way; --most-steps allows more";
}

/// What went wrong on the way, where something did.
std::string trouble_text(const WalkReport& report) {
  std::string text;
  const auto tell = [&](bool MoverStep<Index>::*fact, const char* what) {
    const auto has_it = [&](const WalkedStep& walked) { return walked.step.*fact; };
    const auto count = std::count_if(report.steps.begin(), report.steps.end(), has_it);
    if (count > 0) text += fmt::format("In {} {}.\n", counted(static_cast<std::size_t>(count), "step"), what);
  };
  tell(&MoverStep<Index>::tight, "it is nearer to something than its skin");
  tell(&MoverStep<Index>::stuck, "it overlaps something and finds no way out");
  tell(&MoverStep<Index>::crushed, "something that moves its way cannot push it aside");
  tell(&MoverStep<Index>::cut_short, "it may not have gone as far as it can");
  return text;
}

bool is_stuck(const WalkReport& report) { return !report.steps.empty() && report.steps.back().step.stuck; }

}  // namespace

std::string table_of(const CheckInput& input, const WalkReport& report) {
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  const std::vector<ObjectWalked> objects = objects_walked(report, names.size());
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < objects.size(); ++i)
    if (objects[i].first > 0) rows.push_back(row_of(names[i], objects[i]));
  return columns(rows, 2) + trouble_text(report) +
         fmt::format("From {} to {} in {}: {}.\n", point_text(report.question.from),
                     point_text(place_after(report, report.steps.size())), counted(report.steps.size(), "step"),
                     end_text(report));
}

Summary summary_of(const WalkReport& report) {
  const bool is_there = report.end == WalkOutcome::done || report.end == WalkOutcome::arrived;
  return {"a walk of " + counted(report.steps.size(), "step"), !is_there || is_stuck(report)};
}

Subcommand add_walk(CLI::App& app) {
  const auto arguments = std::make_shared<WalkArguments>();
  CLI::App* walk = app.add_subcommand("walk", "where a character gets that walks in a level, and what it touches");
  add_input(*walk, arguments->input, any_files);
  add_point(*walk, "--from", arguments->from_words, "the point that it stands on at first");
  CLI::Option* to = add_point(*walk, "--to", arguments->to_words, "where it heads for, straight on");
  add_file(*walk, "--motion", arguments->motion,
           "instead what it wants to go in each step, falling included: a file with three numbers a line")
      ->excludes(to);
  for (WalkLength* length : {&arguments->radius, &arguments->height, &arguments->stride, &arguments->fall,
                             &arguments->skin, &arguments->step_height, &arguments->snap})
    add_length(*walk, length->option, length->text, length->help);
  walk->add_option("--max-slope", arguments->max_slope, "the steepest ground that it walks on, in degrees")
      ->check(number_between(0, 90))
      ->capture_default_str();
  walk->add_option("--most-steps", arguments->most_steps, "so many steps at most, on the way --to a point")
      ->check(whole_number(1, 1'000'000'000))
      ->capture_default_str();
  add_up(*walk, *arguments);
  add_solid(*walk, *arguments);
  add_writing(*walk, *arguments, "docs/reference/walk-report.md");
  walk->footer(with_name(
      "It slides along what it meets, walks up slopes and steps, and falls. Lengths are in units of the scene, or with "
      "their own (2mm).\n\n"
      "Exit code: 0 it arrives, or has taken all motions; 1 it does not, or is stuck; 2 trouble.\n\nExample:\n"
      "  {0} walk level.glb --from 0 0 0 --to 12 0 3 --html walk.html\n"
      "  {0} walk floor.obj walls.obj --from 0 0 0 --motion steps.txt --json > walk.json\n"
      "  {0} view walk.json -o walk.html"));
  return {walk, [arguments, walk] {
            require_one_way(*walk);
            take_words(*arguments);
            return run_walk(*arguments, asking_options(*walk));
          }};
}

}  // namespace toccata::command
