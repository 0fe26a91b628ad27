#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "load.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/query_files.hpp"
#include "toccata/io/scene_file.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct SweepArguments : PosedArguments {
  std::string from, to;  ///< poses as they are written
  std::string motion;    ///< a file of many; empty: from the one to the other
  std::string node;      ///< of that file, where it is a glTF file; empty: the one that moves
  bool screw = false;
  std::vector<std::string> centre_words;
  double stop_before = 0;
};

/// Between two poses the shorter way is taken, which is not what a turn of more than half a circle says.
void require_shorter_way(const char* option, const std::string& text) {
  const std::size_t place = text.find("degrees");
  if (place == std::string::npos) return;
  const std::size_t number = text.find_first_not_of("= :,\t", place + std::string("degrees").size());
  const double degrees = number == std::string::npos ? 0 : std::strtod(text.c_str() + number, nullptr);
  if (!(std::abs(degrees) > 180)) return;
  throw Error(fmt::format(
      "{}: a turn of {} degrees is more than half a circle, and from one pose to the next the shorter way is "
      "taken; write poses between into a file for --motion",
      option, degrees));
}

/// The pose that an option tells.
Pose pose_of_option(const char* option, const std::string& text) {
  require_shorter_way(option, text);
  try {
    return pose_from_text(text);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", option, error.what()));
  }
}

/// The motion in a glTF file, which is in metres or in the unit that is given for all files, in the unit of the scene.
FileMotion motion_of_file(const SweepArguments& arguments, const Scene& scene) {
  FileMotion motion = read_motion(arguments.motion, arguments.node);
  if (!motion.is_in_metres) return motion;
  const auto metres_of = [](const std::string& unit) {
    return unit.empty() || unit == "unit" ? 1 : metres_per_unit(unit);
  };
  const double factor = arguments.input.scale * metres_of(arguments.input.unit) / metres_of(scene.unit);
  motion.centre = factor * motion.centre;
  for (MotionKey& key : motion.keys) key.pose.offset = factor * key.pose.offset;
  return motion;
}

FileMotion motion_asked(const SweepArguments& arguments, const Scene& scene) {
  if (!arguments.motion.empty()) return motion_of_file(arguments, scene);
  if (arguments.to.empty())
    throw Error(
        "no motion is given: say where the first file goes with --to POSE, or name a file of poses with --motion");
  const Pose from = arguments.from.empty() ? Pose{} : pose_of_option("--from", arguments.from);
  return {{{0, from}, {1, pose_of_option("--to", arguments.to)}}, {}};
}

/// The objects of the first of two files; of one file, its first object.
std::size_t moving_count(const LoadedScene& loaded) {
  if (loaded.scene.objects.size() < 2)
    throw Error("a sweep is of one object past another: name another file or a scene with more");
  if (loaded.first_object.size() > 3)
    throw Error(fmt::format("a sweep is of one file past another; here are {}", loaded.first_object.size() - 1));
  return loaded.first_object.size() > 2 ? loaded.first_object[1] : 1;
}

int run_sweep(const SweepArguments& arguments) {
  const bool asks_itself = !arguments.from.empty() || !arguments.to.empty() || !arguments.motion.empty() ||
                           arguments.screw || !arguments.centre_words.empty() || arguments.stop_before != 0 ||
                           changes_objects(arguments);
  if (const auto code = answered_case(arguments, {"sweep", asks_itself, false, true})) return *code;
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  const FileMotion motion = motion_asked(arguments, input.loaded.scene);
  SweepQuestion question;
  question.keys = motion.keys;
  question.screw = arguments.screw;
  question.centre = arguments.centre_words.empty() ? motion.centre : parse_point(arguments.centre_words, "--centre");
  question.stop_before = arguments.stop_before;
  question.moving_objects = moving_count(input.loaded);
  return exit_code_of(answer_to(question, input, arguments, "sweeping"));
}

std::vector<std::string> row_of(const CheckInput& input, const std::vector<std::string>& names,
                                const ReportedSweep& pair) {
  const std::optional<ShapeHit>& hit = pair.hit;
  if (!hit) return {names[pair.a], "passes", names[pair.b], "", ""};
  const bool have_faces = input.models[pair.a].model.has_mesh() && input.models[pair.b].model.has_mesh();
  return {names[pair.a], "meets", names[pair.b],
          fmt::format("at fraction {:.12g} of the motion, {}", hit->upper, point_text(hit->point)),
          have_faces ? fmt::format("face {} on face {}", hit->face_a, hit->face_b) : ""};
}

}  // namespace

std::string table_of(const CheckInput& input, const SweepReport& report) {
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  std::size_t undecided = 0;
  for (const ReportedSweep& pair : report.pairs) {
    rows.push_back(row_of(input, names, pair));
    undecided += !pair.hit || pair.hit->status == Status::exact ? 0U : 1U;
  }
  return columns(rows, 2) + fmt::format("{} of {} meet on the way, {}.\n", grouped(meeting_count(report)),
                                        counted(rows.size(), "pair"), decided_text(undecided));
}

Summary summary_of(const SweepReport& report) {
  return {counted(report.pairs.size(), "pair"), meeting_count(report) > 0};
}

Subcommand add_sweep(CLI::App& app) {
  const auto arguments = std::make_shared<SweepArguments>();
  CLI::App* sweep = app.add_subcommand("sweep", "whether something that moves and turns meets what stands, and when");
  add_input(*sweep, arguments->input, "two files (everything in the first moves) or one (its first object moves)");
  add_pose_pair(*sweep, *arguments);
  CLI::Option* from =
      add_text(*sweep, "--from", arguments->from, "where it starts, on top of the pose in its file (default: at that)",
               "a pose must be given");
  CLI::Option* to = add_text(*sweep, "--to", arguments->to,
                             "where it ends, the same way; it turns the shorter way: 'translation=1,0,0 axis=0,0,1 "
                             "degrees=90', 12 numbers, or 3 "
                             "(docs/reference/motion-file.md)",
                             "a pose must be given");
  for (CLI::Option* pose : {from, to}) pose->type_name("POSE");
  CLI::Option* motion = add_file(*sweep, "--motion", arguments->motion,
                                 "many poses: a file with a time and a pose a line, or a glTF file with an animation")
                            ->excludes(from)
                            ->excludes(to);
  add_text(*sweep, "--node", arguments->node, "which node's animation of the glTF file it is, where several move",
           "a name must be given")
      ->needs(motion);
  CLI::Option* centre = add_point(*sweep, "--centre", arguments->centre_words,
                                  "the point of it that goes straight on while it turns (default: its origin)");
  sweep->add_flag("--screw", arguments->screw, "turn about one axis and move along it, instead of straight on")
      ->excludes(centre);
  sweep->add_option("--stop-before", arguments->stop_before, "how near it may come, in units of the scene")
      ->check(number_from(0));
  add_solid(*sweep, *arguments);
  add_writing(*sweep, *arguments, "docs/reference/sweep-report.md");
  sweep->footer(
      with_name("That nothing meets is proved for every moment, not for some of them.\n\n"
                "Exit code: 0 nothing meets, 1 something does, 2 trouble.\n\nExample:\n"
                "  {0} sweep part.stl fixture.stl --to 'translation=0,0,-5 axis=0,0,1 degrees=90' --html sweep.html\n"
                "  {0} sweep gripper.json table.json --motion path.txt --json"));
  return {sweep, [arguments] {
            take_words(*arguments);
            return run_sweep(*arguments);
          }};
}

}  // namespace toccata::command
