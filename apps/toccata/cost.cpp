#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "cost_words.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/reports/output_file.hpp"
#include "toccata/reports/plot.hpp"
#include "toccata/reports/report.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct CostArguments : PosedArguments {
  CostOptions options;
  std::size_t rows = 10;  ///< of each table; 0: all
  std::string svg;        ///< a plot to write; empty: none
  CostWords words;        ///< as the options are written
};

/// Without a file of poses the one that both have; none where there are not two, which is refused when it is asked.
std::vector<PairQuery> queries_of(const CheckInput& input, const CostArguments& arguments) {
  if (input.models.size() != 2) return {};
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

/// Nothing was said about what is measured.
bool is_plain(const CostOptions& given) {
  const CostOptions plain;
  return given.task == plain.task && given.workloads == plain.workloads && given.volumes == plain.volumes &&
         given.arities == plain.arities && given.methods == plain.methods && given.leaf_size == plain.leaf_size &&
         given.most_work == plain.most_work;
}

int run_cost(const CostArguments& arguments) {
  require_distinct({{"--svg", arguments.svg},
                    {"--html", arguments.html},
                    {"--png", arguments.png},
                    {"--glb", arguments.glb},
                    {"--save-case", arguments.save_case}},
                   arguments.input.files);
  if (!arguments.svg.empty()) require_output(arguments.svg, OutputKind::plot);
  const AlsoWritten plot = [&](const CheckInput& input, const SceneAnswer& answer) {
    if (!arguments.svg.empty() && std::holds_alternative<CostReport>(answer))
      write_output(report_plot_svg(report_json(input.loaded.scene, input.models, answer)), arguments.svg,
                   OutputKind::plot);
    return std::string();
  };
  const bool asks_itself = changes_objects(arguments) || !is_plain(arguments.options);
  if (const auto code = answered_case(arguments, {"cost", asks_itself}, plot)) return *code;
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  const CostQuestion question{queries_of(input, arguments), arguments.options};
  const ViewTarget target = target_of(arguments);
  const SceneAnswer answer = ask_for(input, question, arguments, {"measuring"});
  if (draws_something(target)) write_view(target, input, answer);
  (void)plot(input, answer);
  print_answer(input, question, answer, arguments, [&](const SceneAnswer& found) {
    const CostTable& table = std::get<CostReport>(found).table;
    return tables_of(table, arguments.rows == 0 ? table.rows.size() : arguments.rows,
                     remark_on_wide(arguments.options));
  });
  return 0;
}

}  // namespace

std::string table_of(const CheckInput&, const CostReport& report) {
  constexpr std::size_t usual_rows = 10;
  return tables_of(report.table, usual_rows, remark_on_wide(report.question.options));
}

Summary summary_of(const CostReport& report) { return {counted(report.table.rows.size(), "hierarchy", "hierarchies")}; }

Subcommand add_cost(CLI::App& app) {
  const auto arguments = std::make_shared<CostArguments>();
  CLI::App* cost =
      app.add_subcommand("cost", "which bounding volume and hierarchy is cheapest for two meshes, measured");
  add_input(*cost, arguments->input, "two files of one mesh each");
  add_poses(*cost, *arguments);
  CostWords& words = arguments->words;
  const auto list = [&](const char* name, std::vector<std::string>& values, const char* what) {
    cost->add_option(name, values, what)->delimiter(',')->allow_extra_args(false)->type_name("WORD,…");
  };
  cost->add_option("--task", words.task, "what is asked at each pose: overlap, contacts or distance")
      ->capture_default_str();
  list("--workloads", words.workloads, "rigid, refit, rebuild (default: all)");
  list("--volumes", words.volumes, "aabb, obb, 26-dop, … (default: all)");
  list("--builders", words.builders,
       "heuristic, mean, median, equal-regions, morton, agglomeration, insertion (default: all)");
  cost->add_option("--arities", words.arities, "children a node (default: 2,4,8)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(whole_number(0, 1024))
      ->type_name("NUMBER,…");
  cost->add_option("--leaf-size", words.leaf_size, "triangles in a leaf, at most")
      ->check(whole_number(1, 64))
      ->capture_default_str();
  CLI::Option* quick = cost->add_flag("--quick", words.quick, "two builders and two arities, and only what is fast");
  cost->add_flag("--all", words.all, "also what takes long: of large meshes some is left out")->excludes(quick);
  cost->add_option("--rows", arguments->rows, "how many rows of each table to show; 0: all")
      ->check(whole_number(0, 1'000'000))
      ->capture_default_str();
  add_file(*cost, "--svg", arguments->svg,
           "also draw the cheapest hierarchy of each volume as bars (docs/reference/plots.md)", "FILE.svg");
  add_formats(*cost, arguments->format, "docs/reference/cost-report.md");
  add_pages(*cost, *arguments);
  add_glb(*cost, *arguments);
  add_save_case(*cost, arguments->save_case);
  cost->footer(
      with_name("F = N_u·C_u + N_bv·C_bv + N_p·C_p: volumes updated, volumes compared and triangles compared, by what "
                "one of each costs (docs/methods/cost-function.md).\n\nExit code: 0, or 2 for trouble.\n\nExample:\n"
                "  {0} cost part.stl part.stl --pose-b 1 0 0  0 1 0  0 0 1  0.5 0 0 --quick\n"
                "  {0} cost robot.stl table.obj --poses path.txt --task distance"));
  return {cost, [arguments] {
            take_words(*arguments);
            arguments->options = cost_options_of(arguments->words);
            return run_cost(*arguments);
          }};
}

}  // namespace toccata::command
