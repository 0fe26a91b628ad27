#include <fmt/format.h>

#include "answer.hpp"
#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "table_names.hpp"
#include "toccata/core/error.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
std::string table_of(const CheckInput& input, const DistanceReport& report) {
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (const ReportedDistance& pair : report.pairs)
    rows.push_back({names[pair.a], names[pair.b], distance_text(pair.distance), nearest_text(pair.distance)});
  return columns(rows, 2);
}

int run_distance(const DistanceArguments& arguments) {
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

}  // namespace toccata::command
