#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "check_input.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/poses_file.hpp"
#include "toccata/io/poses_report.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// What the file asks about the two models, which keep the poses that their own files give them.
std::vector<PairQuery> queries_about(const std::vector<Posed>& models, const std::string& file) {
  std::vector<PairQuery> queries = read_poses(file);
  for (PairQuery& query : queries)
    query = {compose(query.pose_a, models[0].pose), compose(query.pose_b, models[1].pose), models[0].solid,
             models[1].solid};
  return queries;
}

PosesReport answer_queries(const std::vector<Posed>& models, const CheckArguments& arguments) {
  PosesReport report;
  report.queries = queries_about(models, arguments.poses);
  report.touching = arguments.touching;
  const Model &a = models[0].model, &b = models[1].model;
  {
    ProgressBar bar("checking");
    report.relations = relation_each(a, b, report.queries, {arguments.threads, bar.callback()});
  }
  if (arguments.faces) {
    ProgressBar bar("counting faces");
    report.counts = count_contacts_each(a, b, report.queries, {arguments.threads, bar.callback()});
  }
  return report;
}

std::string poses_table(const Scene& scene, const PosesReport& report) {
  const std::string a = printable(scene.objects[0].name), b = printable(scene.objects[1].name);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.relations.size(); ++i) {
    const Relation& relation = report.relations[i];
    rows.push_back({fmt::format("query {}", i), a, verb(relation), b, remark(relation)});
    if (!report.counts.empty()) rows.back().push_back(counted(report.counts[i].face_pairs, "pair") + " of faces");
  }
  const std::size_t contacts = contact_count(report);
  const auto touching = static_cast<std::size_t>(
      std::count_if(report.relations.begin(), report.relations.end(),
                    [](const Relation& relation) { return relation.kind != RelationKind::apart; }));
  std::string text = columns(rows, 2) + fmt::format("{} of {} in contact, decided exactly.\n", grouped(contacts),
                                                    counted(rows.size(), "query", "queries"));
  if (touching > contacts) text += fmt::format("{} merely touching, ignored as asked.\n", grouped(touching - contacts));
  return text;
}

std::string text_of(const CheckInput& input, const PosesReport& report, Format format) {
  if (format == Format::json) return poses_report_json(input.loaded.scene, input.models, report, input.loaded.warnings);
  return format == Format::csv ? poses_report_csv(report) : poses_table(input.loaded.scene, report);
}

}  // namespace

int run_check_poses(const CheckArguments& arguments) {
  CheckInput input = read_check_input(arguments);
  if (input.models.size() != 2)
    throw Error(fmt::format("--poses asks about two objects, the first placed as A and the second as B; here {} {}",
                            input.models.size() == 1 ? "is" : "are", input.models.size()));
  warn_of_open_meshes(input);
  const PosesReport report = answer_queries(input.models, arguments);
  const std::string text = text_of(input, report, arguments.format);
  print_warnings(input.loaded.warnings);
  print_answer(text);
  return contact_count(report) == 0 ? 0 : 1;
}

}  // namespace toccata::command
