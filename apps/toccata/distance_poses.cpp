#include <fmt/format.h>

#include "answer.hpp"
#include "arguments.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {

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

int run_distance_poses(const PosedArguments& arguments) {
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  const DistancePosesQuestion question{read_queries(input, arguments)};
  return exit_code_of(answer_to(question, input, arguments, "measuring"));
}

}  // namespace toccata::command
