#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace toccata {

/// Values of one kind, drawn in one colour. NaN: was not measured.
struct PlotSeries {
  std::string name;
  std::vector<double> values;  ///< one for each row of the plot
};

/// Bars from left to right, in rows.
struct BarPlot {
  std::string title;
  std::string subtitle{};
  std::string quantity;  ///< what the axis measures and in which unit: "time of a query in µs"
  std::vector<std::string> rows;
  std::vector<PlotSeries> series;
  std::vector<std::string> remarks{};  ///< behind each row; or none
};

struct PlotPoint {
  double x = 0;
  double y = 0;
};

/// Points joined in the order given. One that is not finite interrupts the line.
struct PlotLine {
  std::string name;
  std::vector<PlotPoint> points;
};

struct LinePlot {
  std::string title;
  std::string subtitle{};
  std::string x_quantity;
  std::string y_quantity;
  std::vector<PlotLine> lines;
};

/// An SVG picture, 760 wide, without scripts: dark where its reader's programs are, in colours that people tell apart
/// who see them otherwise. An axis is logarithmic where the positive values span two decades or more and none is
/// negative. Texts may hold anything; names that are too long are cut, and whole in a hint. The same bytes for the same
/// values. Throws Error when a series has not one value for each row.
[[nodiscard]] std::string plot_svg(std::span<const BarPlot> plots);
[[nodiscard]] std::string plot_svg(const LinePlot& plot);

/// The plot of a report, the JSON of `cost` or of a benchmark (docs/reference/plots.md). `name` is for messages. Throws
/// Error when it is neither, or says nothing that could be drawn.
[[nodiscard]] std::string report_plot_svg(std::string_view json, const std::string& name = "report");

}  // namespace toccata
