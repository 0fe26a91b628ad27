#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "check_table.hpp"
#include "load.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/scene_models.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// --pose-a and --pose-b place everything in the first and the second of two files.
void apply_poses(LoadedScene& loaded, const CheckArguments& arguments) {
  if (!arguments.pose_a && !arguments.pose_b) return;
  if (arguments.input.files.size() != 2)
    throw Error(
        fmt::format("--pose-a and --pose-b place the first and the second of two files; here are {}. For more, "
                    "write a scene file (docs/reference/scene-file.md)",
                    arguments.input.files.size()));
  const std::optional<Pose> poses[] = {arguments.pose_a, arguments.pose_b};
  for (std::size_t file = 0; file < 2; ++file) {
    if (!poses[file]) continue;
    for (std::size_t i = loaded.first_object[file]; i < loaded.first_object[file + 1]; ++i)
      loaded.scene.objects[i].pose = compose(*poses[file], loaded.scene.objects[i].pose);
  }
}

void apply_solid(Scene& scene, std::optional<Solid> solid) {
  if (!solid) return;
  for (SceneObject& object : scene.objects) object.solid = *solid;
}

/// An open mesh among solids contains nothing: whoever did not know that it is open should.
void warn_of_open_meshes(LoadedScene& loaded, const std::vector<Posed>& models) {
  constexpr std::size_t most_names = 5;
  std::vector<std::string> open;
  for (const Posed& posed : models)
    if (posed.solid == Solid::automatic && !posed.model.closed()) open.push_back(posed.name);
  if (open.empty()) return;
  const std::size_t shown = std::min(open.size(), most_names);
  loaded.warnings.push_back(fmt::format(
      "{} of {} {} open and taken as surface{}, which contain{} nothing: {}{} (inspect tells why; --solid=none says "
      "that "
      "surfaces are meant)",
      open.size(), counted(models.size(), "object"), open.size() == 1 ? "is" : "are", open.size() == 1 ? "" : "s",
      open.size() == 1 ? "s" : "", fmt::join(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
      shown < open.size() ? ", …" : ""));
}

CheckAnswer answer_with_progress(const std::vector<Posed>& models, const CheckArguments& arguments) {
  ProgressBar bar("checking");
  CheckOptions options;
  options.contacts = arguments.faces;
  options.threads = arguments.threads;
  options.progress = bar.callback();
  return check_all(models, options);
}

std::string text_of(const LoadedScene& loaded, const std::vector<Posed>& models, const CheckReport& report,
                    Format format) {
  switch (format) {
    case Format::json:
      return check_report_json(loaded.scene, models, report, loaded.warnings);
    case Format::csv:
      return check_report_csv(loaded.scene, report);
    case Format::table:
      break;
  }
  return check_table(loaded.scene, report);
}

}  // namespace

int run_check(const CheckArguments& arguments) {
  LoadedScene loaded = load(arguments.input);
  apply_poses(loaded, arguments);
  apply_solid(loaded.scene, arguments.solid);
  if (loaded.scene.objects.size() < 2)
    throw Error(fmt::format("{} holds one object; a check needs two: name another file, or a scene with more objects",
                            arguments.input.files.front()));
  const std::vector<Posed> models = scene_models(loaded.scene, arguments.threads);
  warn_of_open_meshes(loaded, models);
  const CheckAnswer answer = answer_with_progress(models, arguments);
  const CheckReport report = make_check_report(models, answer, arguments.touching, arguments.faces);
  const std::string text = text_of(loaded, models, report, arguments.format);
  print_warnings(loaded.warnings);
  print_answer(text);
  return report.pairs.empty() ? 0 : 1;
}

}  // namespace toccata::command
