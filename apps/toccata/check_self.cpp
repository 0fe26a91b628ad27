#include <fmt/format.h>

#include "answer.hpp"
#include "arguments.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "check_table.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {

std::string table_of(const CheckInput& input, const SelfReport& report) {
  const Scene& scene = input.loaded.scene;
  const std::vector<std::string> names = table_names(scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.objects.size(); ++i) {
    const std::size_t pairs = report.objects[i].face_pairs;
    rows.push_back({names[i], pairs == 0 ? "does not intersect itself"
                                         : fmt::format("self-intersects in {} of faces", counted(pairs, "pair"))});
  }
  const std::size_t intersection = self_intersecting_count(report);
  const std::string last = intersection == 0 ? "Nothing intersects itself, decided exactly.\n"
                                             : fmt::format("{} {}, decided exactly.\n", counted(intersection, "object"),
                                                           intersection == 1 ? "self-intersects" : "self-intersect");
  std::string text = fmt::format("{} with {}, each against itself.\n", counted(rows.size(), "object"),
                                 counted(triangle_count(scene), "triangle"));
  if (!report.has_faces) return text + columns(rows, 2) + last;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += columns({rows[i]}, 2);
    if (!report.objects[i].faces.empty()) text += face_lines(report.objects[i].faces);
  }
  return text + last;
}

Summary summary_of(const SelfReport& report) {
  const std::size_t count = self_intersecting_count(report);
  return {counted(count, "object") + " self-intersecting", count > 0};
}

int run_check_self(const CheckArguments& arguments) {
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  const SelfQuestion question{arguments.faces};
  return exit_code_of(answer_to(question, input, arguments, "checking"));
}

}  // namespace toccata::command
