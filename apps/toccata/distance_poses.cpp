#include <fmt/format.h>

#include "arguments.hpp"
#include "check_input.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/io/distance_report.hpp"
#include "toccata/query/batch.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

DistancePosesReport answer_queries(const CheckInput& input, const DistanceArguments& arguments) {
  ProgressBar bar("measuring");
  DistancePosesReport report{read_queries(input, arguments), {}};
  report.distances =
      distance_each(input.models[0].model, input.models[1].model, report.queries, {arguments.threads, bar.callback()});
  return report;
}

std::string poses_table(const Scene& scene, const DistancePosesReport& report) {
  const std::string a = printable(scene.objects[0].name), b = printable(scene.objects[1].name);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.distances.size(); ++i)
    rows.push_back(
        {fmt::format("query {}", i), a, b, distance_text(report.distances[i]), nearest_text(report.distances[i])});
  return columns(rows, 2) +
         fmt::format("{} of {} meet.\n", grouped(meeting_count(report)), counted(rows.size(), "query", "queries"));
}

std::string text_of(const CheckInput& input, const DistancePosesReport& report, Format format) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return distance_poses_report_json(loaded.scene, input.models, report, loaded.warnings);
  return format == Format::csv ? distance_poses_report_csv(report) : poses_table(loaded.scene, report);
}

}  // namespace

int run_distance_poses(const DistanceArguments& arguments) {
  const CheckInput input = read_check_input(arguments);
  const DistancePosesReport report = answer_queries(input, arguments);
  const std::string text = text_of(input, report, arguments.format);
  print_warnings(input.loaded.warnings);
  print_answer(text);
  return meeting_count(report) == 0 ? 0 : 1;
}

}  // namespace toccata::command
