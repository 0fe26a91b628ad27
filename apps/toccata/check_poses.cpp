#include <fmt/format.h>

#include <algorithm>

#include "answer.hpp"
#include "arguments.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "subcommands.hpp"
#include "table_names.hpp"
#include "toccata/io/report.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {

std::string table_of(const CheckInput& input, const PosesReport& report) {
  const std::vector<std::string> names = table_names(input.loaded.scene.objects);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < report.relations.size(); ++i) {
    const Relation& relation = report.relations[i];
    rows.push_back({fmt::format("query {}", i), names[0], verb_of(relation), names[1], remark_on(relation)});
    const bool has_depth = relation.kind != RelationKind::apart;
    if (!report.penetrations.empty()) rows.back().push_back(has_depth ? depth_text(report.penetrations[i]) : "");
    if (!report.counts.empty()) rows.back().push_back(counted(report.counts[i].face_pairs, "pair") + " of faces");
  }
  const std::size_t contacts = contact_count(report);
  const auto touching = static_cast<std::size_t>(
      std::count_if(report.relations.begin(), report.relations.end(),
                    [](const Relation& relation) { return relation.kind != RelationKind::apart; }));
  const auto undecided = static_cast<std::size_t>(
      std::count_if(report.relations.begin(), report.relations.end(), [](const Relation& relation) {
        return relation.kind == RelationKind::touching && relation.status != Status::exact;
      }));
  std::string text = columns(rows, 2) + fmt::format("{} of {} in contact, {}.\n", grouped(contacts),
                                                    counted(rows.size(), "query", "queries"), decided_text(undecided));
  if (touching > contacts) text += fmt::format("{} merely touching, ignored as asked.\n", grouped(touching - contacts));
  return text;
}

Summary summary_of(const PosesReport& report) {
  return {counted(report.queries.size(), "pose"), contact_count(report) > 0};
}

int run_check_poses(const CheckArguments& arguments) {
  require_view(arguments);
  CheckInput input = read_check_input(arguments);
  warn_of_open_meshes(input);
  const CheckPosesQuestion question{read_queries(input, arguments), arguments.touching, arguments.faces,
                                    arguments.penetration};
  return exit_code_of(answer_to(question, input, arguments, "checking"));
}

}  // namespace toccata::command
