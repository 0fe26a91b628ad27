#include <fmt/format.h>

#include "arguments.hpp"
#include "check_input.hpp"
#include "check_table.hpp"
#include "clearance.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/check_all.hpp"
#include "view.hpp"

namespace toccata::command {
CheckAnswer answer_with_progress(const std::vector<Posed>& models, const CheckArguments& arguments,
                                 const ClearanceQuestion& clearances) {
  ProgressBar bar("checking");
  CheckOptions options;
  options.contacts = arguments.faces || !arguments.html.empty() || !arguments.glb.empty();
  options.penetration = arguments.penetration;
  options.clearance = clearances.common;
  options.pair_clearances = clearances.of_pairs;
  options.threads = arguments.threads;
  options.progress = bar.callback();
  return check_all(models, options);
}

namespace {

ViewTarget target_of(const CheckArguments& arguments) {
  const std::vector<std::string>& files = arguments.input.files;
  return {arguments.html, arguments.glb, {title_of(files), up_of(files), {}}, {}};
}

/// What is drawn is written when the answer is complete, and before it is printed.
void write_drawn(const ViewTarget& target, const CheckInput& input, const CheckAnswer& answer,
                 const ReportOptions& options) {
  if (target.path.empty() && target.glb.empty()) return;
  ReportOptions with_faces = options;
  with_faces.faces = true;
  write_view(target, input, make_check_report(input.models, answer, with_faces));
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
  if (!arguments.poses.empty()) return run_check_poses(arguments);
  if (arguments.self) return run_check_self(arguments);
  require_touching_counts(arguments);
  const ViewTarget target = target_of(arguments);
  require_view(target, arguments.input.files);
  CheckInput input = read_check_input(arguments);
  LoadedScene& loaded = input.loaded;
  if (loaded.scene.objects.size() < 2)
    throw Error(
        fmt::format("{} holds one object; a check needs two: name another file or a scene with more objects, "
                    "or say --self to check it against itself",
                    arguments.input.files.front()));
  warn_of_open_meshes(input);
  const ClearanceQuestion clearances = read_clearances(arguments, loaded.scene);
  const CheckAnswer answer = answer_with_progress(input.models, arguments, clearances);
  const ReportOptions options{arguments.touching, arguments.faces, arguments.penetration, clearances.common,
                              clearances.of_pairs};
  const CheckReport report = make_check_report(input.models, answer, options);
  const std::string text = text_of(loaded, input.models, report, arguments.format);
  print_warnings(loaded.warnings);
  write_drawn(target, input, answer, options);
  print_answer(text);
  return report.pairs.empty() ? 0 : 1;
}

}  // namespace toccata::command
