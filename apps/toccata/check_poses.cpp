#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "check_input.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/io/poses_report.hpp"
#include "toccata/io/relation_words.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

PosesReport answer_queries(const CheckInput& input, const CheckArguments& arguments) {
  PosesReport report;
  report.queries = read_queries(input, arguments);
  report.touching = arguments.touching;
  const Model &a = input.models[0].model, &b = input.models[1].model;
  {
    ProgressBar bar("checking");
    report.relations = relation_each(a, b, report.queries, {arguments.threads, bar.callback()});
  }
  if (arguments.faces) {
    ProgressBar bar("counting faces");
    report.counts = count_contacts_each(a, b, report.queries, {arguments.threads, bar.callback()});
  }
  if (arguments.penetration) {
    ProgressBar bar("measuring depths");
    report.penetrations = penetration_each(a, b, report.queries, {arguments.threads, bar.callback()});
    if (a.has_mesh() && b.has_mesh())
      report.regions = contact_regions_each(a, b, report.queries, {arguments.threads, {}});
  }
  return report;
}

std::string poses_table(const Scene& scene, const PosesReport& report) {
  const std::string a = printable(scene.objects[0].name), b = printable(scene.objects[1].name);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.relations.size(); ++i) {
    const Relation& relation = report.relations[i];
    rows.push_back({fmt::format("query {}", i), a, verb_of(relation), b, remark_on(relation)});
    const bool has_depth = relation.kind != RelationKind::apart;
    if (!report.penetrations.empty()) rows.back().push_back(has_depth ? depth_text(report.penetrations[i]) : "");
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
  const PosesReport report = answer_queries(input, arguments);
  warn_of_open_meshes(input);
  const std::string text = text_of(input, report, arguments.format);
  print_warnings(input.loaded.warnings);
  print_answer(text);
  return contact_count(report) == 0 ? 0 : 1;
}

}  // namespace toccata::command
