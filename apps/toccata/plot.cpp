#include <fmt/format.h>

#include "arguments.hpp"
#include "file_text.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/output_file.hpp"
#include "toccata/io/plot.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

std::string report_in(const std::string& file) {
  const std::string text = text_of_file(file);
  if (text.empty()) throw Error(file + ": the file cannot be read, or is empty; name a report in JSON");
  return text;
}

}  // namespace

int run_plot(const PlotArguments& arguments) {
  require_distinct({{"-o", arguments.svg}}, {arguments.file});
  require_output(arguments.svg, OutputKind::plot);
  const std::string svg = report_plot_svg(report_in(arguments.file), arguments.file);
  const UninterruptedWriting writing;
  write_output(svg, arguments.svg, OutputKind::plot);
  print_answer(fmt::format("{}: a plot of {}.\n", printable(arguments.svg), printable(arguments.file)));
  return 0;
}

}  // namespace toccata::command
