#include <fmt/format.h>

#include "arguments.hpp"
#include "ask.hpp"
#include "check_input.hpp"
#include "check_table.hpp"
#include "clearance.hpp"
#include "toccata/core/error.hpp"
#include "view.hpp"

namespace toccata::command {

CheckQuestion check_question(const CheckArguments& arguments, bool faces, const ClearanceQuestion& clearances) {
  return {arguments.touching, faces, arguments.penetration, clearances.common, clearances.of_pairs};
}

namespace {

ViewTarget target_of(const CheckArguments& arguments) {
  const std::vector<std::string>& files = arguments.input.files;
  return {arguments.html, arguments.glb, {title_of(files), up_of(files), {}}, {}};
}

}  // namespace

std::string table_of(const CheckInput& input, const CheckReport& report) {
  return check_table(input.loaded.scene, report);
}

int run_check(const CheckArguments& arguments) {
  if (!arguments.poses.empty()) return run_check_poses(arguments);
  if (arguments.self) return run_check_self(arguments);
  require_touching_counts(arguments);
  const ViewTarget target = target_of(arguments);
  require_view(target, arguments);
  CheckInput input = read_check_input(arguments);
  LoadedScene& loaded = input.loaded;
  if (loaded.scene.objects.size() < 2)
    throw Error(
        fmt::format("{} holds one object; a check needs two: name another file or a scene with more objects, "
                    "or say --self to check it against itself",
                    arguments.input.files.front()));
  warn_of_open_meshes(input);
  const bool is_drawn = !target.path.empty() || !target.glb.empty();  // with the faces, whether they are listed or not
  CheckQuestion question =
      check_question(arguments, arguments.faces || is_drawn, read_clearances(arguments, loaded.scene));
  SceneAnswer answer = ask_for(input, question, arguments, "checking");
  CheckReport& report = std::get<CheckReport>(answer);
  if (is_drawn) write_view(target, input, report);
  question.faces = report.has_faces = arguments.faces;
  print_answer(input, question, answer, arguments);
  return report.pairs.empty() ? 0 : 1;
}

}  // namespace toccata::command
