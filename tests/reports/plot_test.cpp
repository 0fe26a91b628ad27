// Plots: well-formed, inside their frame, and the same bytes, whatever the values and the names.
#include "toccata/reports/plot.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "math/constants.hpp"
#include "reports/plots/plot_axis.hpp"
#include "support/command.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/output_file.hpp"

namespace toccata {
namespace {

using PropertyTree = boost::property_tree::ptree;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double greatest = std::numeric_limits<double>::max();

double number_of(const PropertyTree& element, const char* name) {
  return element.get<double>(std::string("<xmlattr>.") + name);
}

/// Throws unless it is XML.
PropertyTree parsed(const std::string& svg) {
  std::istringstream stream(svg);
  PropertyTree tree;
  boost::property_tree::read_xml(stream, tree);
  return tree.get_child("svg");
}

/// What is drawn lies in the picture.
void expect_inside(const std::string& svg) {
  const PropertyTree picture = parsed(svg);
  const double width = number_of(picture, "width"), height = number_of(picture, "height");
  EXPECT_EQ(width, 760);
  const auto inside = [&](double x, double y) {
    EXPECT_TRUE(x >= 0 && x <= width && y >= 0 && y <= height) << x << ", " << y << "\n" << svg;
  };
  for (const auto& [kind, element] : picture) {
    if (kind == "rect" && element.count("<xmlattr>") != 0 && element.get("<xmlattr>.class", "") != "paper") {
      inside(number_of(element, "x"), number_of(element, "y"));
      inside(number_of(element, "x") + number_of(element, "width"),
             number_of(element, "y") + number_of(element, "height"));
      EXPECT_GE(number_of(element, "width"), 0);
    }
    if (kind == "line") {
      inside(number_of(element, "x1"), number_of(element, "y1"));
      inside(number_of(element, "x2"), number_of(element, "y2"));
    }
    if (kind == "text") inside(number_of(element, "x"), number_of(element, "y"));
    if (kind == "circle") inside(number_of(element, "cx"), number_of(element, "cy"));
  }
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

BarPlot bars_of(const std::vector<double>& values, const std::vector<double>& more = {}) {
  BarPlot plot{"Title", "", "time in ns", {}, {{"first", values}}, {}};
  if (!more.empty()) plot.series.push_back({"second", more});
  for (std::size_t i = 0; i < values.size(); ++i) plot.rows.push_back("row " + std::to_string(i));
  return plot;
}

std::string svg_of(const BarPlot& plot) { return plot_svg(std::array{plot}); }

/// The widths of the bars of a class.
std::vector<double> widths(const std::string& svg, const std::string& look) {
  std::vector<double> all;
  for (const auto& [kind, element] : parsed(svg))
    if (kind == "rect" && element.get("<xmlattr>.class", "") == look && element.count("title") != 0)
      all.push_back(number_of(element, "width"));
  return all;
}

TEST(Plot, AFewBarsAreTheseLines) {
  const std::string svg = svg_of(bars_of({1, 2}));
  const std::string drawn = svg.substr(svg.find("</style>") + 9);
  EXPECT_EQ(drawn, R"(<rect width="760" height="152" class="paper"/>
<text x="16.0" y="28.0" font-size="16" text-anchor="start" class="ink">Title</text>
<line x1="61.8" y1="44.0" x2="61.8" y2="100.0" class="grid"/>
<text x="61.8" y="115.0" font-size="11" text-anchor="middle" class="soft">0</text>
<line x1="213.3" y1="44.0" x2="213.3" y2="100.0" class="grid"/>
<text x="213.3" y="115.0" font-size="11" text-anchor="middle" class="soft">0.5</text>
<line x1="364.9" y1="44.0" x2="364.9" y2="100.0" class="grid"/>
<text x="364.9" y="115.0" font-size="11" text-anchor="middle" class="soft">1</text>
<line x1="516.4" y1="44.0" x2="516.4" y2="100.0" class="grid"/>
<text x="516.4" y="115.0" font-size="11" text-anchor="middle" class="soft">1.5</text>
<line x1="668.0" y1="44.0" x2="668.0" y2="100.0" class="grid"/>
<text x="668.0" y="115.0" font-size="11" text-anchor="middle" class="soft">2</text>
<text x="364.9" y="133.0" font-size="12" text-anchor="middle" class="soft">time in ns</text>
<text x="53.8" y="64.0" font-size="13" text-anchor="end" class="ink">row 0</text>
<rect x="61.8" y="52.0" width="303.1" height="15.0" class="s0"><title>row 0, first: 1</title></rect>
<text x="369.9" y="63.5" font-size="11" text-anchor="start" class="soft">1</text>
<text x="53.8" y="88.0" font-size="13" text-anchor="end" class="ink">row 1</text>
<rect x="61.8" y="76.0" width="606.2" height="15.0" class="s0"><title>row 1, first: 2</title></rect>
<text x="673.0" y="87.5" font-size="11" text-anchor="start" class="soft">2</text>
<line x1="61.8" y1="44.0" x2="61.8" y2="100.0" class="frame"/>
</svg>
)") << svg;
}

TEST(Plot, BarsAreAsLongAsTheirValues) {
  const std::vector<double> drawn = widths(svg_of(bars_of({10, 20, 5, 0})), "s0");
  ASSERT_EQ(drawn.size(), 3U);  // nothing has no bar
  EXPECT_NEAR(drawn[1], 2 * drawn[0], 0.11);
  EXPECT_NEAR(drawn[0], 2 * drawn[2], 0.11);
  const std::vector<double> by_logarithm = widths(svg_of(bars_of({1, 10, 100, 1000})), "s0");
  ASSERT_EQ(by_logarithm.size(), 4U);
  for (std::size_t i = 2; i < 4; ++i)
    EXPECT_NEAR(by_logarithm[i] - by_logarithm[i - 1], by_logarithm[1] - by_logarithm[0], 0.11);
  EXPECT_GT(by_logarithm[0], 10);
}

TEST(Plot, ValuesOfEveryKindAreInsideTheFrame) {
  const std::vector<double> wicked{0,    -0.0,   1,        -1,        nan,   infinity, -infinity, 5e-324,
                                   1e-9, 1e-300, greatest, -greatest, 1e300, 1234567,  0.1,       99.99};
  expect_inside(svg_of(bars_of({})));
  for (const double one : wicked) {
    expect_inside(svg_of(bars_of({one})));
    for (const double other : wicked) {
      expect_inside(svg_of(bars_of({one, other}, {other, one})));
      expect_inside(plot_svg(LinePlot{"t", "", "x", "y", {{"a", {{one, other}, {other, one}, {1, 2}}}}}));
    }
  }
  expect_inside(svg_of(bars_of(wicked)));
  expect_inside(plot_svg(LinePlot{"none", "", "x", "y", {}}));
}

TEST(Plot, RandomValuesAreInsideTheFrame) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> power(-12, 12);
  for (int i = 0; i < 300; ++i) {
    std::vector<double> values(1 + random() % 20);
    for (double& value : values) value = std::pow(10, power(random)) * (i % 3 == 0 && random() % 4 == 0 ? -1 : 1);
    const std::string svg = svg_of(bars_of(values));
    expect_inside(svg);
    EXPECT_EQ(svg, svg_of(bars_of(values)));
  }
}

TEST(Plot, NamesAreTextAndFit) {
  const std::string wicked = "</text><script>alert(1)</script>&amp;\"' \x01\x1f \xff \xef\xbf\xbf 齿轮🐰";
  BarPlot plot = bars_of({1, 2}, {3, 4});
  plot.rows = {wicked, std::string(500, 'W')};
  plot.title = plot.subtitle = plot.quantity = plot.series[0].name = plot.series[1].name =
      wicked + std::string(300, 'm');
  plot.remarks = {wicked, std::string(200, 'i')};
  const std::string svg = svg_of(plot);
  expect_inside(svg);
  EXPECT_NE(svg.find("…"), std::string::npos);
  EXPECT_NE(svg.find("<title>" + std::string(500, 'W') + "</title>"), std::string::npos);
  EXPECT_EQ(parsed(svg).get<std::string>("title").substr(0, 20), wicked.substr(0, 20));
  expect_inside(plot_svg(LinePlot{wicked, wicked, wicked, wicked, {{wicked, {{1, 1}}}, {wicked, {{2, 2}}}}}));
}

TEST(Plot, AxesHaveRoundTicks) {
  const auto ticks = [](const std::vector<double>& values) {
    return io::PlotAxis(values, io::PlotAxis::From::zero).ticks();
  };
  EXPECT_EQ(ticks({3, 11}), (std::vector<double>{0, 2, 4, 6, 8, 10, 12}));
  EXPECT_EQ(ticks({-30, 60}), (std::vector<double>{-40, -20, 0, 20, 40, 60}));
  EXPECT_EQ(ticks({5, 5000}), (std::vector<double>{1, 10, 100, 1000, 10000}));
  EXPECT_EQ(ticks({}), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
  EXPECT_EQ(io::plot_number(1234567), "1,234,567");
  EXPECT_EQ(io::plot_number(0.6000000000000001), "0.6");
  EXPECT_EQ(io::plot_number(1e12), "1e12");
  EXPECT_EQ(io::plot_number(1.25e-7), "1.25e-7");
  EXPECT_EQ(io::plot_number(-12345), "-12,345");
}

TEST(Plot, LinesAreInterruptedWhereNothingWasMeasured) {
  const std::string svg =
      plot_svg(LinePlot{"t", "", "x", "y", {{"a", {{1, 1}, {2, 2}, {3, nan}, {4, 4}, {5, 5}}}, {"b", {}}}});
  expect_inside(svg);
  const std::string path = parsed(svg).get<std::string>("path.<xmlattr>.d");
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 2);
  EXPECT_EQ(parsed(svg).count("circle"), 4U);
}

TEST(Plot, SeriesOfAnotherLengthAreRefused) {
  BarPlot plot = bars_of({1, 2});
  plot.series[0].values.pop_back();
  EXPECT_THROW(static_cast<void>(svg_of(plot)), Error);
  plot = bars_of({1, 2});
  plot.remarks = {"one"};
  EXPECT_THROW(static_cast<void>(svg_of(plot)), Error);
}

const std::string cost_report =
    R"({"schema": "toccata/cost/1", "task": "contacts", "objects": [{"name": "a"}, {"name": "b"}], "rows": [
  {"workload": "rigid", "volume": "wide", "arity": 8, "builder": "heuristic", "queries": 2, "N_u": 0, "C_u_ns": 0, "N_bv": 100, "C_bv_ns": 10, "N_p": 0, "C_p_ns": 0, "F_ns": 500},
  {"workload": "rigid", "volume": "obb", "arity": 2, "builder": "mean", "queries": 2, "N_u": 10, "C_u_ns": 100, "N_bv": 40, "C_bv_ns": 50, "N_p": 20, "C_p_ns": 40, "F_ns": 1900},
  {"workload": "rigid", "volume": "obb", "arity": 4, "builder": "mean", "queries": 2, "N_u": 10, "C_u_ns": 100, "N_bv": 50, "C_bv_ns": 50, "N_p": 20, "C_p_ns": 40, "F_ns": 2150},
  {"workload": "refit", "volume": "obb", "arity": 2, "builder": "mean", "queries": 1, "N_u": 10, "C_u_ns": 100, "N_bv": 40, "C_bv_ns": 50, "N_p": 20, "C_p_ns": 40, "F_ns": 3800}]})";

TEST(ReportPlot, OfCostsShowsTheTermsOfTheCheapestRows) {
  const std::string svg = report_plot_svg(cost_report);
  expect_inside(svg);
  EXPECT_NE(svg.find("What a query costs: rigid"), std::string::npos);
  EXPECT_NE(svg.find("contacts of a and b"), std::string::npos);
  EXPECT_NE(svg.find("obb, 2 children, mean, N_bv · C_bv, volumes compared: 1,000"), std::string::npos);
  EXPECT_NE(svg.find("F 1900 ns"), std::string::npos);
  EXPECT_EQ(svg.find("obb, 4 children"), std::string::npos);
  EXPECT_NE(svg.find("What a query costs: refit"), std::string::npos);
}

TEST(ReportPlot, OfBenchmarksShowsEveryResult) {
  const std::string head =
      R"({"format": "toccata-bench-1", "benchmark": "mesh", "question": {"mesh_a": "gen:torus", "seed": 1, "gains": []}, "results": [)";
  const std::string bars = report_plot_svg(
      head +
      R"({"library": "toccata", "variant": "Model", "task": "contacts", "threads": 1, "median_us": 20, "p99_us": 40},
                {"library": "fcl", "variant": "OBB", "task": "contacts", "threads": 2, "median_us": 2000, "p99_us": null}]})");
  expect_inside(bars);
  EXPECT_NE(bars.find("mesh: contacts"), std::string::npos);
  EXPECT_NE(bars.find("mesh_a gen:torus, seed 1"), std::string::npos);
  EXPECT_NE(bars.find("fcl: OBB, 2 threads"), std::string::npos);
  EXPECT_NE(bars.find("logarithmic"), std::string::npos);
  EXPECT_NE(bars.find("not measured"), std::string::npos);
  std::string rows;
  for (const int threads : {1, 2, 4, 8})
    rows += (rows.empty() ? "" : ",") +
            std::string(R"({"library": "toccata", "variant": "Model", "task": "build", "median_us": 0, "build_ms": )") +
            std::to_string(8 / threads) + R"(, "threads": )" + std::to_string(threads) + "}";
  const std::string lines = report_plot_svg(head + rows + "]}");
  expect_inside(lines);
  EXPECT_EQ(parsed(lines).count("circle"), 4U);
}

TEST(ReportPlot, OfFramesShowsTheirMedianAndWorst) {
  const std::string svg = report_plot_svg(
      R"({"format": "toccata-bench-1", "benchmark": "broad", "question": {"scene": "uniform"}, "results": [
        {"library": "toccata", "variant": "auto", "threads": 1, "median_ms": 12.5, "mean_ms": 13, "worst_ms": 20}]})");
  expect_inside(svg);
  EXPECT_NE(svg.find("toccata: auto"), std::string::npos);
  EXPECT_NE(svg.find("worst"), std::string::npos);
}

TEST(ReportPlot, OfAnythingElseIsRefused) {
  for (const char* json : {"[]", "{}", "3", "{\"schema\": \"toccata/check/2\"}", "nonsense", "",
                           R"({"format": "toccata-bench-1", "benchmark": "b", "question": {}, "results": []})",
                           R"({"schema": "toccata/cost/1", "task": "t", "rows": []})",
                           R"({"schema": "toccata/cost/1", "task": "t", "rows": [{"workload": 3}]})"})
    EXPECT_THROW(static_cast<void>(report_plot_svg(json)), Error) << json;
}

TEST(ReportPlot, IsKnownAgainAsItsOwn) {
  const test::TemporaryFolder folder;
  const std::string svg = report_plot_svg(cost_report);
  write_output(svg, folder.path() / "a.svg", OutputKind::plot);
  write_output(svg, folder.path() / "a.svg", OutputKind::plot);
  EXPECT_THROW(write_output(svg, folder.write("b.svg", "<svg/>"), OutputKind::plot), Error);
}

}  // namespace
}  // namespace toccata
