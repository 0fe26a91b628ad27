#include "reports/plots/plot_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/formats/utf8.hpp"

namespace toccata::io {
namespace {

/// Colours of M. Okabe and K. Ito ("Color universal design", 2008), those of the page.
constexpr std::string_view style = R"(<style>
  text { font-family: system-ui, sans-serif; fill: #16202b; }
  .soft { fill: #5a6775; }
  .paper { fill: #ffffff; }
  .grid { stroke: #dde2e8; }
  .frame { stroke: #5a6775; }
  path { fill: none; stroke-width: 2; }
  .s0 { fill: #0072b2; } .s1 { fill: #e69f00; } .s2 { fill: #009e73; } .s3 { fill: #cc79a7; }
  .s4 { fill: #56b4e9; } .s5 { fill: #d55e00; } .s6 { fill: #8a94a0; }
  path.s0 { fill: none; stroke: #0072b2; } path.s1 { fill: none; stroke: #e69f00; }
  path.s2 { fill: none; stroke: #009e73; } path.s3 { fill: none; stroke: #cc79a7; }
  path.s4 { fill: none; stroke: #56b4e9; } path.s5 { fill: none; stroke: #d55e00; }
  path.s6 { fill: none; stroke: #8a94a0; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e8edf2; } .soft { fill: #9fb0c2; } .paper { fill: #14181d; }
    .grid { stroke: #262d35; } .frame { stroke: #9fb0c2; }
  }
</style>
)";
constexpr std::size_t looks = 7;

/// The bytes of the character that begins here.
std::size_t length_of(unsigned char first) { return first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4; }

double width_of(std::string_view character, double size) {
  constexpr double narrow = 0.55, wide = 1.05;  // of the size; sans-serif letters are about so wide on average
  const bool is_wide = character.size() == 4 || (character.size() == 3 && character >= "\xe1\x84\x80" &&
                                                 !(character >= "\xe2\x80\x80" && character < "\xe2\xba\x80"));
  return size * (is_wide ? wide : narrow);
}

}  // namespace

double text_width(std::string_view text, double size) {
  double width = 0;
  for (std::size_t i = 0; i < text.size(); i += length_of(static_cast<unsigned char>(text[i])))
    width += width_of(text.substr(i, length_of(static_cast<unsigned char>(text[i]))), size);
  return width;
}

std::string fitting(const std::string& text, double size, double width) {
  std::string whole = as_utf8(text);
  if (text_width(whole, size) <= width) return whole;
  const std::string dots = "…";
  double used = text_width(dots, size);
  std::size_t end = 0;
  while (end < whole.size()) {
    const std::size_t length = length_of(static_cast<unsigned char>(whole[end]));
    used += width_of(std::string_view(whole).substr(end, length), size);
    if (used > width) break;
    end += length;
  }
  return whole.substr(0, end) + dots;
}

std::string in_xml(std::string_view text) {
  std::string safe;
  for (const char c : as_utf8(text)) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      safe += ' ';
    else
      safe += c;
  }
  // Two characters that XML has no place for.
  for (const std::string_view none : {"\xef\xbf\xbe", "\xef\xbf\xbf"})
    for (std::size_t at; (at = safe.find(none)) != std::string::npos;) safe.replace(at, none.size(), "\xef\xbf\xbd");
  return safe;
}

std::string series_look(std::size_t number) { return fmt::format("s{}", number % looks); }

void PlotCanvas::rectangle(double x, double y, double width, double height, const std::string& look,
                           const std::string& hint) {
  body_ += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" class="{}")", x, y, width, height,
                       look);
  body_ += hint.empty() ? "/>\n" : "><title>" + in_xml(hint) + "</title></rect>\n";
}

void PlotCanvas::line(double x1, double y1, double x2, double y2, const char* look) {
  body_ += fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" class="{}"/>)", x1, y1, x2, y2, look);
  body_ += '\n';
}

void PlotCanvas::path(const std::string& commands, const std::string& look) {
  body_ += fmt::format(R"(<path d="{}" class="{}"/>)", commands, look) + "\n";
}

void PlotCanvas::circle(double x, double y, const std::string& look, const std::string& hint) {
  body_ += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="3.5" class="{}"><title>{}</title></circle>)", x, y, look,
                       in_xml(hint));
  body_ += '\n';
}

void PlotCanvas::text(const PlotText& place, const std::string& text) {
  static constexpr const char* anchors[] = {"start", "middle", "end"};
  const std::string shown = fitting(text, place.size, place.room);
  const bool is_cut = shown != as_utf8(text);
  body_ +=
      fmt::format(R"(<text x="{:.1f}" y="{:.1f}" font-size="{}" text-anchor="{}" class="{}"{}>{}{}</text>)", place.x,
                  place.y, place.size, anchors[static_cast<std::size_t>(place.anchor)], place.look,
                  place.upright ? fmt::format(R"~( transform="rotate(-90 {:.1f} {:.1f})")~", place.x, place.y) : "",
                  is_cut ? "<title>" + in_xml(text) + "</title>" : "", in_xml(shown));
  body_ += '\n';
}

double PlotCanvas::heading(double y, const std::string& title, const std::string& subtitle) {
  constexpr double room = plot_width - 2 * plot_margin;
  text({.x = plot_margin, .y = y + 20, .size = 16, .room = room}, title);
  if (subtitle.empty()) return y + 32;
  text({.x = plot_margin, .y = y + 38, .size = 12, .look = "soft", .room = room}, subtitle);
  return y + 50;
}

double PlotCanvas::legend(double y, const std::vector<std::string>& names) {
  constexpr double swatch = 11, gap = 22, size = 12, height = 18;
  if (names.size() < 2) return y;
  double x = plot_margin;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double room = plot_width - 2 * plot_margin - swatch - 5;
    const double width = swatch + 5 + std::min(text_width(as_utf8(names[i]), size), room) + gap;
    if (x > plot_margin && x + width - gap > plot_width - plot_margin) {
      x = plot_margin;
      y += height;
    }
    rectangle(x, y, swatch, swatch, series_look(i));
    text({.x = x + swatch + 5, .y = y + swatch - 1, .size = size, .room = room}, names[i]);
    x += width;
  }
  return y + height + 4;
}

std::string PlotCanvas::file(double height, const std::string& title) const {
  return fmt::format(
             "<!-- Plot of Toccata -->\n"
             R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1:.0f}" viewBox="0 0 {0} {1:.0f}" role="img">)"
             "\n<title>{2}</title>\n",
             plot_width, height, in_xml(title)) +
         std::string(style) + fmt::format(R"(<rect width="{}" height="{:.0f}" class="paper"/>)", plot_width, height) +
         "\n" + body_ + "</svg>\n";
}

}  // namespace toccata::io
