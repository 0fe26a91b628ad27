#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "option_kinds.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

int run_distance_poses(const PosedArguments& arguments) {
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  const DistancePosesQuestion question{read_queries(input, arguments)};
  return exit_code_of(answer_to(question, input, arguments, "measuring"));
}

int run_distance(const PosedArguments& arguments) {
  if (const auto code = answered_case(arguments, {"distance", changes_objects(arguments)})) return *code;
  if (!arguments.poses.empty()) return run_distance_poses(arguments);
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  const LoadedScene& loaded = input.loaded;
  if (loaded.scene.objects.size() < 2)
    throw Error(fmt::format("{} holds one object; a distance is between two: name another file or a scene with more",
                            arguments.input.files.front()));
  const std::vector<std::size_t>& first_object = loaded.first_object;
  const DistanceQuestion question{first_object.size() == 3 ? first_object[1] : 0};
  return exit_code_of(answer_to(question, input, arguments, "measuring"));
}

}  // namespace

std::string table_of(const CheckInput& input, const DistanceReport& report) {
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (const ReportedDistance& pair : report.pairs)
    rows.push_back({names[pair.a], names[pair.b], distance_text(pair.distance), nearest_text(pair.distance)});
  return columns(rows, 2);
}

Summary summary_of(const DistanceReport& report) {
  const auto meet = [](const ReportedDistance& pair) { return pair.distance.upper == 0; };
  return {counted(report.pairs.size(), "pair"), std::any_of(report.pairs.begin(), report.pairs.end(), meet)};
}

std::string table_of(const CheckInput& input, const DistancePosesReport& report) {
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.distances.size(); ++i)
    rows.push_back({fmt::format("query {}", i), names[0], names[1], distance_text(report.distances[i]),
                    nearest_text(report.distances[i])});
  return columns(rows, 2) +
         fmt::format("{} of {} meet.\n", grouped(intersecting_count(report)), counted(rows.size(), "query", "queries"));
}

Summary summary_of(const DistancePosesReport& report) {
  return {counted(report.queries.size(), "pose"), intersecting_count(report) > 0};
}

Subcommand add_distance(CLI::App& app) {
  const auto arguments = std::make_shared<PosedArguments>();
  CLI::App* distance = app.add_subcommand("distance", "how far apart shapes are, certified");
  add_input(*distance, arguments->input,
            "one file (all pairs of its objects) or two (pairs of one of each): meshes or scenes");
  add_poses(*distance, *arguments);
  add_solid(*distance, *arguments);
  add_writing(*distance, *arguments, "docs/reference/distance-report.md");
  distance->footer(
      with_name("Exit code: 0 nothing meets, 1 something does, 2 trouble.\n\nExample:\n  {0} distance a.stl b.obj\n"
                "  {0} distance shapes.json\n  {0} distance robot.json table.json --poses path.txt --csv"));
  return {distance, [arguments] {
            take_words(*arguments);
            return run_distance(*arguments);
          }};
}

}  // namespace toccata::command
