#include <fmt/format.h>

#include "arguments.hpp"
#include "check_input.hpp"
#include "check_table.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/io/self_report.hpp"
#include "toccata/query/self_contacts.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

SelfReport answer(const std::vector<Posed>& models, const CheckArguments& arguments) {
  ProgressBar bar("checking");
  return make_self_report(models, self_contacts_each(models, {arguments.threads, bar.callback()}), arguments.faces);
}

std::string self_table(const Scene& scene, const SelfReport& report) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.objects.size(); ++i) {
    const std::size_t pairs = report.objects[i].face_pairs;
    rows.push_back(
        {printable(scene.objects[i].name),
         pairs == 0 ? "does not meet itself" : fmt::format("meets itself in {} of faces", counted(pairs, "pair"))});
  }
  const std::size_t meeting = self_meeting_count(report);
  const std::string last = meeting == 0 ? "Nothing meets itself, decided exactly.\n"
                                        : fmt::format("{} {} itself, decided exactly.\n", counted(meeting, "object"),
                                                      meeting == 1 ? "meets" : "meet");
  std::string text = fmt::format("{} with {}, each against itself.\n", counted(rows.size(), "object"),
                                 counted(triangle_count(scene), "triangle"));
  if (!report.has_faces) return text + columns(rows, 2) + last;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += columns({rows[i]}, 2);
    if (!report.objects[i].faces.empty()) text += face_lines(report.objects[i].faces);
  }
  return text + last;
}

std::string text_of(const CheckInput& input, const SelfReport& report, Format format) {
  const LoadedScene& loaded = input.loaded;
  if (format == Format::json) return self_report_json(loaded.scene, input.models, report, loaded.warnings);
  return format == Format::csv ? self_report_csv(loaded.scene, report) : self_table(loaded.scene, report);
}

}  // namespace

int run_check_self(const CheckArguments& arguments) {
  const CheckInput input = read_check_input(arguments);
  const SelfReport report = answer(input.models, arguments);
  const std::string text = text_of(input, report, arguments.format);
  print_warnings(input.loaded.warnings);
  print_answer(text);
  return self_meeting_count(report) == 0 ? 0 : 1;
}

}  // namespace toccata::command
