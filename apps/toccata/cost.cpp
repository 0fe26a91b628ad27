#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "check_input.hpp"
#include "cost_words.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/cost_report.hpp"
#include "toccata/io/output_file.hpp"
#include "toccata/io/plot.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

const TriangleMesh& mesh_of(const Posed& posed) {
  if (!posed.model.has_mesh())
    throw Error(fmt::format("'{}' is a {}; costs are measured of meshes", posed.name, name_of(posed.model.shape())));
  return posed.model.mesh();
}

std::vector<PairQuery> queries_of(const CheckInput& input, const CostArguments& arguments) {
  if (input.models.size() != 2)
    throw Error(fmt::format("costs are measured of two meshes; here {} {}: name two files of one mesh each",
                            input.models.size() == 1 ? "is" : "are", input.models.size()));
  if (!arguments.poses.empty()) return read_queries(input, arguments);
  return {{input.models[0].pose, input.models[1].pose}};
}

std::string plain_number(double number) {
  return number < 100 ? fmt::format("{:.3g}", number) : grouped(static_cast<std::size_t>(number + 0.5));
}

/// Counts of one query.
std::vector<std::string> cells_of(const CostRow& row) {
  const auto count = [&](std::size_t all) {
    return plain_number(static_cast<double>(all) / static_cast<double>(row.queries));
  };
  return {std::string(name_of(row.volume)),  fmt::format("{}", row.arity), std::string(name_of(row.method)),
          count(row.counts.volumes_updated), plain_number(row.update_ns),  count(row.counts.volume_tests),
          plain_number(row.test_ns),         count(row.counts.items),      plain_number(row.item_ns),
          plain_number(row.cost()),          plain_number(row.measured_ns)};
}

std::string table_of(const CostTable& table, CostWorkload workload, std::size_t most) {
  std::vector<std::vector<std::string>> rows{
      {"volume", "arity", "builder", "N_u", "C_u", "N_bv", "C_bv", "N_p", "C_p", "F", "as it ran"}};
  std::size_t count = 0, queries = 0;
  for (const CostRow& row : table.rows)
    if (row.workload == workload) {
      queries = row.queries;
      if (++count <= most) rows.push_back(cells_of(row));
    }
  if (count == 0) return "";
  std::string text = fmt::format("{}: {}\n", name_of(workload), meaning_of(workload)) + columns(rows, 2);
  if (count > most) text += fmt::format("  … and {} (--rows 0 shows all)\n", counted(count - most, "dearer row"));
  text += fmt::format("  of one query, in nanoseconds; mean of {}\n", counted(queries, "query", "queries"));
  for (const std::string& line : explain_winner(table, workload)) text += "  - " + line + "\n";
  return text;
}

std::string tables_of(const CostTable& table, std::size_t most, const std::string& remark) {
  std::string text;
  for (const CostWorkload workload : all_cost_workloads) text += table_of(table, workload, most);
  if (!remark.empty()) text += remark + ".\n";
  for (const std::string& line : table.left_out) text += "left out: " + line + "\n";
  if (!table.left_out.empty()) text += "--all measures these too.\n";
  return text;
}

}  // namespace

int run_cost(const CostArguments& arguments) {
  require_distinct({{"--svg", arguments.svg}}, arguments.input.files);
  if (!arguments.svg.empty()) require_output(arguments.svg, OutputKind::plot);
  const CheckInput input = read_check_input(arguments);
  const std::vector<PairQuery> queries = queries_of(input, arguments);
  CostTable table;
  {
    ProgressBar bar("measuring");
    CostOptions options = arguments.options;
    options.progress = bar.callback();
    table = measure_costs(mesh_of(input.models[0]), mesh_of(input.models[1]), queries, options);
  }
  const LoadedScene& loaded = input.loaded;
  const std::size_t most = arguments.rows == 0 ? table.rows.size() : arguments.rows;
  const std::string json = cost_report_json(loaded.scene, input.models, table, loaded.warnings);
  const std::string text = arguments.format == Format::json ? json
                           : arguments.format == Format::csv
                               ? cost_report_csv(table)
                               : tables_of(table, most, remark_on_wide(arguments.options));
  print_warnings(loaded.warnings);
  if (!arguments.svg.empty()) write_output(report_plot_svg(json), arguments.svg, OutputKind::plot);
  print_answer(text);
  return 0;
}

}  // namespace toccata::command
