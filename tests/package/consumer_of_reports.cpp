// A user of the library of reports, beside the engine. Exit status 0 when it is right.
#include <toccata/reports.hpp>

#include <array>
#include <cstdio>
#include <string>

int main() {
  const std::array plots{toccata::BarPlot{
      .title = "Gaps", .quantity = "distance in mm", .rows = {"a and b"}, .series = {{"gap", {0.25}}}}};
  const std::string drawing = toccata::plot_svg(plots);
  std::printf("a plot of %zu bytes\n", drawing.size());
  return drawing.find("a and b") != std::string::npos ? 0 : 1;
}
