#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reports/plots/plot_canvas.hpp"
#include "toccata/reports/plot.hpp"

namespace toccata {
namespace {

using io::PlotAxis;
using io::PlotCanvas;
using io::TextAnchor;

constexpr double plot_height = 300, text_size = 11;

std::vector<double> numbers_of(const LinePlot& plot, double PlotPoint::*part) {
  std::vector<double> numbers;
  for (const PlotLine& line : plot.lines)
    for (const PlotPoint& point : line.points)
      if (std::isfinite(point.x) && std::isfinite(point.y)) numbers.push_back(point.*part);
  return numbers;
}

class LineDrawing {
 public:
  LineDrawing(const LinePlot& plot, PlotCanvas& canvas)
      : plot_(plot),
        canvas_(canvas),
        x_(numbers_of(plot, &PlotPoint::x), PlotAxis::From::least),
        y_(numbers_of(plot, &PlotPoint::y), PlotAxis::From::zero) {}

  double draw(double top) {
    top = canvas_.heading(top, plot_.title, plot_.subtitle);
    std::vector<std::string> names;
    for (const PlotLine& line : plot_.lines) names.push_back(line.name);
    top_ = canvas_.legend(top, names) + 8;
    draw_axes();
    for (std::size_t i = 0; i < plot_.lines.size(); ++i) draw_line(plot_.lines[i], io::series_look(i));
    return top_ + plot_height + 48;
  }

 private:
  [[nodiscard]] double across(double x) const { return left_ + (right_ - left_) * x_.place_of(x); }
  [[nodiscard]] double down(double y) const { return top_ + plot_height * (1 - y_.place_of(y)); }

  /// What has no place on a logarithmic axis is left out.
  [[nodiscard]] bool is_shown(const PlotPoint& point) const {
    return std::isfinite(point.x) && std::isfinite(point.y) && (!x_.is_logarithmic() || point.x > 0) &&
           (!y_.is_logarithmic() || point.y > 0);
  }

  void draw_axes() {
    for (const double tick : x_.ticks()) {
      canvas_.line(across(tick), top_, across(tick), top_ + plot_height, "grid");
      canvas_.text({.x = across(tick),
                    .y = top_ + plot_height + 16,
                    .size = text_size,
                    .anchor = TextAnchor::middle,
                    .look = "soft"},
                   io::plot_number(tick));
    }
    for (const double tick : y_.ticks()) {
      canvas_.line(left_, down(tick), right_, down(tick), "grid");
      canvas_.text({.x = left_ - 6, .y = down(tick) + 4, .size = text_size, .anchor = TextAnchor::end, .look = "soft"},
                   io::plot_number(tick));
    }
    canvas_.line(left_, top_, left_, top_ + plot_height, "frame");
    canvas_.line(left_, top_ + plot_height, right_, top_ + plot_height, "frame");
    const auto told = [](const PlotAxis& axis, const std::string& quantity) {
      return quantity + (axis.is_logarithmic() ? " (logarithmic)" : "");
    };
    canvas_.text({.x = (left_ + right_) / 2,
                  .y = top_ + plot_height + 36,
                  .size = 12,
                  .anchor = TextAnchor::middle,
                  .look = "soft",
                  .room = right_ - left_},
                 told(x_, plot_.x_quantity));
    canvas_.text({.x = 24,
                  .y = top_ + plot_height / 2,
                  .size = 12,
                  .anchor = TextAnchor::middle,
                  .look = "soft",
                  .room = plot_height,
                  .upright = true},
                 told(y_, plot_.y_quantity));
  }

  void draw_line(const PlotLine& line, const std::string& look) {
    std::string commands;
    bool is_joined = false;
    for (const PlotPoint& point : line.points) {
      if (is_shown(point))
        commands += fmt::format("{}{:.1f} {:.1f}",
                                is_joined          ? " L"
                                : commands.empty() ? "M"
                                                   : " M",
                                across(point.x), down(point.y));
      is_joined = is_shown(point);
    }
    if (!commands.empty()) canvas_.path(commands, look);
    for (const PlotPoint& point : line.points)
      if (is_shown(point))
        canvas_.circle(across(point.x), down(point.y), look,
                       fmt::format("{}: {}, {}", line.name, io::plot_number(point.x), io::plot_number(point.y)));
  }

  const LinePlot& plot_;
  PlotCanvas& canvas_;
  PlotAxis x_, y_;
  double left_ = 100, right_ = io::plot_width - 40, top_ = 0;
};

}  // namespace

std::string plot_svg(const LinePlot& plot) {
  PlotCanvas canvas;
  const double bottom = LineDrawing(plot, canvas).draw(8);
  return canvas.file(bottom, plot.title);
}

}  // namespace toccata
