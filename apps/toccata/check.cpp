#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "answer.hpp"
#include "arguments.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "check_table.hpp"
#include "clearance.hpp"
#include "option_kinds.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "view.hpp"

namespace toccata::command {
namespace {

int run_check(const CheckArguments& arguments) {
  const bool asks_itself = arguments.self || arguments.faces || arguments.penetration ||
                           arguments.touching != Touching::count || !arguments.clearance.empty() ||
                           !arguments.clearances_of.empty() || changes_objects(arguments);
  if (const auto code = answered_case(arguments, {"check", asks_itself, true})) return *code;
  if (!arguments.poses.empty()) return run_check_poses(arguments);
  if (arguments.self) return run_check_self(arguments);
  require_touching_counts(arguments);
  require_view(arguments);
  CheckInput input = read_check_input(arguments);
  LoadedScene& loaded = input.loaded;
  if (loaded.scene.objects.size() < 2)
    throw Error(
        fmt::format("{} holds one object; a check needs two: name another file or a scene with more objects, "
                    "or say --self to check it against itself",
                    arguments.input.files.front()));
  warn_of_open_meshes(input);
  const CheckQuestion question = check_question(arguments, arguments.faces, read_clearances(arguments, loaded.scene));
  return exit_code_of(answer_to(question, input, arguments, "checking"));
}

}  // namespace

CheckQuestion check_question(const CheckArguments& arguments, bool faces, const ClearanceQuestion& clearances) {
  return {arguments.touching, faces, arguments.penetration, clearances.common, clearances.of_pairs};
}

std::string table_of(const CheckInput& input, const CheckReport& report) {
  return check_table(input.loaded.scene, report);
}

Summary summary_of(const CheckReport& report) { return {counted(report.pairs.size(), "pair"), !report.pairs.empty()}; }

Subcommand add_check(CLI::App& app) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* check = app.add_subcommand("check", "which objects touch, decided exactly");
  add_input(*check, arguments->input, any_files);
  CLI::Option* poses = add_poses(*check, *arguments);
  CLI::Option* solid = add_solid(*check, *arguments);
  CLI::Option* touching = check->add_option("--touching", arguments->touching_word, "whether merely touching counts")
                              ->check(CLI::IsMember({"count", "ignore"}))
                              ->capture_default_str();
  CLI::Option* penetration = check->add_flag("--penetration", arguments->penetration,
                                             "how deep solids overlap, a way to part them, their regions of contact "
                                             "and (without --poses) their points of contact");
  const auto [clearance, clearance_of] = add_clearances(*check, *arguments);
  clearance->excludes(poses);
  clearance_of->excludes(poses);
  check
      ->add_flag("--self", arguments->self,
                 "each object against itself, instead of against the others: where its own faces meet")
      ->excludes(poses)
      ->excludes(penetration)
      ->excludes(clearance)
      ->excludes(clearance_of)
      ->excludes(solid)
      ->excludes(touching);
  check->add_flag("--faces", arguments->faces,
                  "list the faces that meet, by the files' own numbers from 0; with --poses, count them");
  add_writing(*check, *arguments, "docs/reference/check-report.md");
  check->footer(
      with_name("Exit code: 0 nothing touches or is nearer than its clearance, 1 something is, 2 trouble.\n\n"
                "Example:\n"
                "  {0} demo --write scenes\n"
                "  {0} check scenes/a.obj scenes/b.stl --faces\n"
                "  {0} check part.stl part.stl --pose-b 1 0 0  0 1 0  0 0 1  0.5 0 0\n"
                "  {0} check robot.stl table.obj --poses path.txt --csv\n"
                "  {0} check part.stl --self --faces\n"
                "  {0} check shapes.json --penetration\n"
                "  {0} check cell.json --clearance 2mm --clearance-of robot,table=5cm\n"
                "  {0} check a.stl b.stl --html report.html\n"
                "  {0} check scenes/shelf/scene.json --json"));
  return {check, [arguments] {
            take_words(*arguments);
            arguments->touching = arguments->touching_word == "ignore" ? Touching::ignore : Touching::count;
            return run_check(*arguments);
          }};
}

}  // namespace toccata::command
