#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "arguments.hpp"
#include "file_text.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/output_file.hpp"
#include "toccata/reports/plot.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct PlotArguments {
  std::string file;  ///< a report in JSON
  std::string svg;
};

std::string report_in(const std::string& file) {
  std::string text = text_of_file(file);
  if (text.empty()) throw Error(file + ": the file cannot be read, or is empty; name a report in JSON");
  return text;
}

int run_plot(const PlotArguments& arguments) {
  require_distinct({{"-o", arguments.svg}}, {arguments.file});
  require_output(arguments.svg, OutputKind::plot);
  const std::string svg = report_plot_svg(report_in(arguments.file), arguments.file);
  const UninterruptedWriting writing;
  write_output(svg, arguments.svg, OutputKind::plot);
  print_answer(fmt::format("{}: a plot of {}.\n", printable(arguments.svg), printable(arguments.file)));
  return 0;
}

}  // namespace

Subcommand add_plot(CLI::App& app) {
  const auto arguments = std::make_shared<PlotArguments>();
  CLI::App* plot = app.add_subcommand("plot", "draw a report of `cost` or of a benchmark");
  plot->add_option("file", arguments->file, "the report in JSON")->required()->type_name("FILE.json");
  add_file(*plot, "-o,--output", arguments->svg, "the picture to write", "FILE.svg")->required();
  plot->footer(
      with_name("Exit code: 0 written, 2 trouble.\n\nExample:\n"
                "  {0} cost a.stl b.stl --json > cost.json\n  {0} plot cost.json -o cost.svg"));
  return {plot, [arguments] { return run_plot(*arguments); }};
}

}  // namespace toccata::command
