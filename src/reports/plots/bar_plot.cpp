#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reports/plots/plot_canvas.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/plot.hpp"

namespace toccata {
namespace {

using io::PlotAxis;
using io::PlotCanvas;
using io::TextAnchor;

constexpr double name_size = 13, value_size = 11, value_room = 76, row_gap = 8;

void require_values(const BarPlot& plot) {
  for (const PlotSeries& series : plot.series)
    if (series.values.size() != plot.rows.size())
      throw Error(fmt::format("the series '{}' has {} values for {} rows", series.name, series.values.size(),
                              plot.rows.size()));
  if (!plot.remarks.empty() && plot.remarks.size() != plot.rows.size())
    throw Error(fmt::format("there are {} remarks for {} rows", plot.remarks.size(), plot.rows.size()));
}

PlotAxis axis_of(const BarPlot& plot) {
  std::vector<double> values;
  for (const PlotSeries& series : plot.series) values.insert(values.end(), series.values.begin(), series.values.end());
  return {values, PlotAxis::From::zero};
}

/// The widest of these texts, up to a limit.
double width_of(const std::vector<std::string>& texts, double size, double most) {
  double width = 0;
  for (const std::string& text : texts) width = std::max(width, io::text_width(text, size));
  return std::min(width, most);
}

class BarDrawing {
 public:
  BarDrawing(const BarPlot& plot, PlotCanvas& canvas) : plot_(plot), canvas_(canvas), axis_(axis_of(plot)) {
    const double names = width_of(plot.rows, name_size, 290), remarks = width_of(plot.remarks, value_size, 150);
    left_ = io::plot_margin + names + 10;
    right_ = io::plot_width - io::plot_margin - (remarks > 0 ? remarks + 10 : 0) - value_room;
    bar_ = plot.series.size() < 2 ? 16 : plot.series.size() < 4 ? 11 : 7;
    row_ = bar_ * static_cast<double>(std::max<std::size_t>(plot.series.size(), 1)) + row_gap;
  }

  double draw(double y) {
    y = canvas_.heading(y, plot_.title, plot_.subtitle);
    std::vector<std::string> names;
    for (const PlotSeries& series : plot_.series) names.push_back(series.name);
    const double top = canvas_.legend(y, names) + 4;
    const double bottom = top + row_ * static_cast<double>(plot_.rows.size()) + row_gap;
    draw_axis(top, bottom);
    for (std::size_t row = 0; row < plot_.rows.size(); ++row)
      draw_row(row, top + row_gap + row_ * static_cast<double>(row));
    const double zero = at(0);
    canvas_.line(zero, top, zero, bottom, "frame");
    return bottom + 44;
  }

 private:
  [[nodiscard]] double at(double value) const { return left_ + (right_ - left_) * axis_.place_of(value); }

  void draw_axis(double top, double bottom) {
    for (const double tick : axis_.ticks()) {
      canvas_.line(at(tick), top, at(tick), bottom, "grid");
      canvas_.text({.x = at(tick), .y = bottom + 15, .size = value_size, .anchor = TextAnchor::middle, .look = "soft"},
                   io::plot_number(tick));
    }
    canvas_.text({.x = (left_ + right_) / 2,
                  .y = bottom + 33,
                  .size = 12,
                  .anchor = TextAnchor::middle,
                  .look = "soft",
                  .room = right_ - left_ + value_room},
                 plot_.quantity + (axis_.is_logarithmic() ? " (logarithmic)" : ""));
  }

  void draw_row(std::size_t row, double y) {
    const double middle = y + (row_ - row_gap) / 2;
    canvas_.text({.x = left_ - 8,
                  .y = middle + 4,
                  .size = name_size,
                  .anchor = TextAnchor::end,
                  .room = left_ - 8 - io::plot_margin},
                 plot_.rows[row]);
    for (std::size_t i = 0; i < plot_.series.size(); ++i) draw_bar(row, i, y + bar_ * static_cast<double>(i));
    if (!plot_.remarks.empty())
      canvas_.text({.x = io::plot_width - io::plot_margin,
                    .y = middle + 4,
                    .size = value_size,
                    .anchor = TextAnchor::end,
                    .look = "soft",
                    .room = 150},
                   plot_.remarks[row]);
  }

  /// A value that is infinite has a bar to the end; one that was not measured none.
  void draw_bar(std::size_t row, std::size_t series, double y) {
    const double value = plot_.series[series].values[row];
    const double zero = at(0), end = std::isnan(value) ? zero : at(value);
    const std::string number = io::plot_number(value);
    if (end != zero)
      canvas_.rectangle(std::min(zero, end), y, std::abs(end - zero), bar_ - 1, io::series_look(series),
                        plot_.rows[row] + ", " + plot_.series[series].name + ": " + number);
    if (bar_ >= value_size)
      canvas_.text({.x = std::max(zero, end) + 5, .y = y + bar_ / 2 + 3.5, .size = value_size, .look = "soft"}, number);
  }

  const BarPlot& plot_;
  PlotCanvas& canvas_;
  PlotAxis axis_;
  double left_ = 0, right_ = 0, bar_ = 0, row_ = 0;
};

}  // namespace

std::string plot_svg(std::span<const BarPlot> plots) {
  PlotCanvas canvas;
  double y = 8;
  std::string title;
  for (const BarPlot& plot : plots) {
    require_values(plot);
    y = BarDrawing(plot, canvas).draw(y) + 8;
    title += (title.empty() ? "" : "; ") + plot.title;
  }
  return canvas.file(y, title);
}

}  // namespace toccata
