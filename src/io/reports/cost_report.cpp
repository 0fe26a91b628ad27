#include "toccata/io/report.hpp"

#include <fmt/format.h>

#include "io/reports/report_parts.hpp"

namespace toccata {
namespace {

using io::Json;

Json json_of(const CostRow& row) {
  return {{"workload", name_of(row.workload)},
          {"volume", name_of(row.volume)},
          {"arity", row.arity},
          {"builder", name_of(row.method)},
          {"leaf_size", row.leaf_size},
          {"queries", row.queries},
          {"N_u", row.counts.volumes_updated},
          {"C_u_ns", row.update_ns},
          {"N_bv", row.counts.volume_tests},
          {"C_bv_ns", row.test_ns},
          {"N_p", row.counts.items},
          {"C_p_ns", row.item_ns},
          {"F_ns", row.cost()},
          {"measured_ns", row.measured_ns},
          {"build_ns", row.build_ns},
          {"nodes", row.nodes},
          {"bytes", row.bytes},
          {"greatest_depth", row.greatest_depth}};
}

Json winners_of(const CostTable& table) {
  Json winners = Json::object();
  for (const CostWorkload workload : all_cost_workloads)
    if (const auto lines = explain_winner(table, workload); !lines.empty())
      winners[std::string(name_of(workload))] = lines;
  return winners;
}

}  // namespace

std::string cost_report_json(const Scene& scene, std::span<const SceneInstance> models, const CostTable& table,
                             std::span<const std::string> warnings) {
  Json json = io::report_head("toccata/cost/1", scene, models, warnings);
  json["task"] = name_of(table.task);
  json["answers"] = table.answers;
  json["winners"] = winners_of(table);
  json["left_out"] = table.left_out;
  return io::with_list(io::document(json), "rows", table.rows.size(),
                       [&](std::size_t i) { return io::line_of(json_of(table.rows[i])); });
}

std::string cost_report_csv(const CostTable& table) {
  std::string csv =
      "workload,volume,arity,builder,leaf_size,queries,N_u,C_u_ns,N_bv,C_bv_ns,N_p,C_p_ns,F_ns,measured_ns,build_ns,"
      "nodes,bytes,greatest_depth\n";
  for (const CostRow& row : table.rows)
    csv +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", name_of(row.workload),
                    name_of(row.volume), row.arity, name_of(row.method), row.leaf_size, row.queries,
                    row.counts.volumes_updated, row.update_ns, row.counts.volume_tests, row.test_ns, row.counts.items,
                    row.item_ns, row.cost(), row.measured_ns, row.build_ns, row.nodes, row.bytes, row.greatest_depth);
  return csv;
}

}  // namespace toccata
