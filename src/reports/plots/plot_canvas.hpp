#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/plots/plot_axis.hpp"

namespace toccata::io {

constexpr double plot_width = 760;
constexpr double plot_margin = 16;

/// About how wide a text is, and what of it fits. Characters of Asia and pictures count twice.
[[nodiscard]] double text_width(std::string_view text, double size);
[[nodiscard]] std::string fitting(const std::string& text, double size, double width);

/// A text that is safe in XML: valid UTF-8 without control characters and markup.
[[nodiscard]] std::string in_xml(std::string_view text);

enum class TextAnchor { start, middle, end };

struct PlotText {
  double x = 0;
  double y = 0;
  double size = 13;
  TextAnchor anchor = TextAnchor::start;
  const char* look = "ink";  ///< a class of the style
  double room = plot_width;  ///< what does not fit is cut
  bool upright = false;      ///< turned to be read from below to above
};

/// An SVG file in the making, drawn from above to below.
class PlotCanvas {
 public:
  void rectangle(double x, double y, double width, double height, const std::string& look,
                 const std::string& hint = "");
  void line(double x1, double y1, double x2, double y2, const char* look);
  void path(const std::string& commands, const std::string& look);
  void circle(double x, double y, const std::string& look, const std::string& hint);
  void text(const PlotText& place, const std::string& text);

  /// Title and subtitle; returns where what follows begins.
  double heading(double y, const std::string& title, const std::string& subtitle);
  /// Names beside their colours, in as many lines as it takes; nothing for a single one.
  double legend(double y, const std::vector<std::string>& names);

  [[nodiscard]] std::string file(double height, const std::string& title) const;

 private:
  std::string body_;
};

/// The class of a series.
[[nodiscard]] std::string series_look(std::size_t number);

}  // namespace toccata::io
