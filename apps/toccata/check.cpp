#include <fmt/format.h>

#include "answer.hpp"
#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "check_table.hpp"
#include "clearance.hpp"
#include "toccata/core/error.hpp"
#include "view.hpp"

namespace toccata::command {

CheckQuestion check_question(const CheckArguments& arguments, bool faces, const ClearanceQuestion& clearances) {
  return {arguments.touching, faces, arguments.penetration, clearances.common, clearances.of_pairs};
}

std::string table_of(const CheckInput& input, const CheckReport& report) {
  return check_table(input.loaded.scene, report);
}

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

}  // namespace toccata::command
