#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "math/constants.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

io::Json json_of(const CostRow& row) {
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

io::Json winners_of(const CostTable& table) {
  io::Json winners = io::Json::object();
  for (const CostWorkload workload : all_cost_workloads)
    if (const auto lines = explain_winner(table, workload); !lines.empty())
      winners[std::string(name_of(workload))] = lines;
  return winners;
}

const TriangleMesh& mesh_of(const SceneInstance& posed) {
  if (!posed.model.has_mesh())
    throw Error(fmt::format("'{}' is a {}; costs are measured of meshes", posed.name, name_of(posed.model.shape())));
  return posed.model.mesh();
}

struct CostKind {
  using Question = CostQuestion;
  using Report = CostReport;
  static constexpr const char* name = "cost";

  static io::Json write(const CostQuestion& question) {
    const CostOptions& options = question.options;
    io::Json json = {{"task", name_of(options.task)},
                     {"workloads", io::names_of(options.workloads)},
                     {"volumes", io::names_of(options.volumes)},
                     {"arities", options.arities},
                     {"builders", io::names_of(options.methods)},
                     {"leaf_size", options.leaf_size},
                     {"most_rigid", options.most_rigid},
                     {"most_updating", options.most_updating},
                     {"most_work", std::isinf(options.most_work) ? io::Json("all") : io::Json(options.most_work)}};
    io::add_queries(json, question.queries);
    return json;
  }

  static CostQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "task", "workloads", "volumes", "arities", "builders", "leaf_size", "most_rigid",
                       "most_updating", "most_work", "poses", "solid"});
    constexpr std::array all_tasks{CostTask::overlap, CostTask::contacts, CostTask::distance};
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
    CostQuestion question;
    question.queries = io::queries_read_from(value);
    CostOptions& options = question.options;
    if (value.has("task")) options.task = io::one_named<CostTask>(value.at("task"), all_tasks);
    io::take_list<CostWorkload>(options.workloads, value, "workloads", all_cost_workloads);
    io::take_list<CostVolume>(options.volumes, value, "volumes", all_cost_volumes);
    io::take_list<BvhMethod>(options.methods, value, "builders", all_bvh_methods);
    if (value.has("arities")) {
      options.arities.clear();
      for (const io::JsonValue& arity : value.elements("arities"))
        options.arities.push_back(static_cast<int>(arity.whole(8)));
    }
    options.leaf_size = static_cast<Index>(value.whole_or("leaf_size", 64, options.leaf_size));
    if (options.leaf_size == 0) value.at("leaf_size").fail("a leaf holds nothing", "write 1 or more");
    options.most_rigid = value.whole_or("most_rigid", most, options.most_rigid);
    options.most_updating = value.whole_or("most_updating", most, options.most_updating);
    if (!value.has("most_work")) return question;
    const io::JsonValue work = value.at("most_work");
    const bool is_all = work.is_string() && work.text() == "all";
    options.most_work = is_all ? infinity : work.number();
    return question;
  }

  static CostReport ask(const CostQuestion& question, const io::Asking& asking) {
    if (asking.models.size() != 2)
      throw Error(fmt::format("costs are measured of two meshes; here {} {}: name two files of one mesh each",
                              asking.models.size() == 1 ? "is" : "are", asking.models.size()));
    CostOptions options = question.options;
    options.progress = asking.options.progress;
    return {measure_costs(mesh_of(asking.models[0]), mesh_of(asking.models[1]), question.queries, options), question};
  }

  static std::string json(const CostReport& report, const io::Reporting& reporting) {
    io::Json json = reporting.head("toccata/cost/1");
    json["task"] = name_of(report.table.task);
    json["answers"] = report.table.answers;
    json["winners"] = winners_of(report.table);
    json["left_out"] = report.table.left_out;
    return io::with_list(io::document(json), "rows", report.table.rows.size(),
                         [&](std::size_t i) { return io::line_of(json_of(report.table.rows[i])); });
  }

  static std::string csv(const CostReport& report, const Scene&) {
    std::string csv =
        "workload,volume,arity,builder,leaf_size,queries,N_u,C_u_ns,N_bv,C_bv_ns,N_p,C_p_ns,F_ns,measured_ns,build_ns,"
        "nodes,bytes,greatest_depth\n";
    for (const CostRow& row : report.table.rows)
      csv +=
          fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", name_of(row.workload),
                      name_of(row.volume), row.arity, name_of(row.method), row.leaf_size, row.queries,
                      row.counts.volumes_updated, row.update_ns, row.counts.volume_tests, row.test_ns, row.counts.items,
                      row.item_ns, row.cost(), row.measured_ns, row.build_ns, row.nodes, row.bytes, row.greatest_depth);
    return csv;
  }
};

}  // namespace

constinit const io::QuestionKind CostQuestion::kind = io::question_kind<CostKind>();

}  // namespace toccata
