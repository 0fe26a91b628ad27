#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "io/formats/json_value.hpp"
#include "toccata/reports/plot.hpp"

namespace toccata {
namespace {

using io::JsonValue;

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// A unit of time in which these nanoseconds have few digits.
struct TimeUnit {
  const char* name;
  double nanoseconds;
};

TimeUnit unit_for(double greatest_ns) {
  if (greatest_ns >= 1e10) return {"s", 1e9};
  if (greatest_ns >= 1e7) return {"ms", 1e6};
  return greatest_ns >= 1e4 ? TimeUnit{"µs", 1e3} : TimeUnit{"ns", 1};
}

double number_or_nan(const JsonValue& row, const char* key) {
  return row.has(key) && row.at(key).is_number() ? row.at(key).number() : not_measured;
}

std::string number_text(const JsonValue& value) {
  if (!value.is_number()) return value.is_string() ? value.text() : "";
  const double number = value.number();
  return number == std::floor(number) && std::abs(number) < 1e15 ? fmt::format("{:.0f}", number)
                                                                 : fmt::format("{:.4g}", number);
}

/// "key value, key value" of all members that are texts or numbers.
std::string told(const JsonValue& object) {
  std::string text;
  for (const std::string& key : object.keys())
    if (const std::string value = number_text(object.at(key)); !value.empty())
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, value);
  return text;
}

// --- cost

/// What a query costs by the terms of F; the rows of a workload ascend by it.
BarPlot cost_plot(const std::string& workload, const std::vector<JsonValue>& rows, const std::string& subtitle) {
  double greatest = 0;
  for (const JsonValue& row : rows) greatest = std::max(greatest, row.at("F_ns").number());
  const TimeUnit unit = unit_for(greatest);
  BarPlot plot{fmt::format("What a query costs: {}", workload),
               subtitle,
               fmt::format("{} of a query", unit.name),
               {},
               {{"N_u · C_u, volumes updated", {}},
                {"N_bv · C_bv, volumes compared", {}},
                {"N_p · C_p, triangles compared", {}}},
               {}};
  constexpr std::array<std::array<const char*, 2>, 3> terms{
      {{"N_u", "C_u_ns"}, {"N_bv", "C_bv_ns"}, {"N_p", "C_p_ns"}}};
  for (const JsonValue& row : rows) {
    plot.rows.push_back(fmt::format("{}, {} children, {}", row.at("volume").text(), number_text(row.at("arity")),
                                    row.at("builder").text()));
    plot.remarks.push_back(fmt::format("F {:.4g} {}", row.at("F_ns").number() / unit.nanoseconds, unit.name));
    for (std::size_t i = 0; i < terms.size(); ++i)
      plot.series[i].values.push_back(row.at(terms[i][0]).number() * row.at(terms[i][1]).number() /
                                      (row.at("queries").number() * unit.nanoseconds));
  }
  return plot;
}

/// Plots the cheapest row of each volume, which comes first.
std::string cost_svg(const JsonValue& report) {
  std::vector<std::string> workloads;
  std::vector<std::vector<JsonValue>> rows;
  for (const JsonValue& row : report.at("rows").elements()) {
    const std::string workload = row.at("workload").text(), volume = row.at("volume").text();
    if (workloads.empty() || workloads.back() != workload) {
      workloads.push_back(workload);
      rows.emplace_back();
    }
    const bool is_first = std::none_of(rows.back().begin(), rows.back().end(),
                                       [&](const JsonValue& other) { return other.at("volume").text() == volume; });
    if (is_first) rows.back().push_back(row);
  }
  if (rows.empty()) report.fail("there are no rows", "measure something");
  std::string objects;
  for (const JsonValue& object : report.elements("objects"))
    objects += (objects.empty() ? "" : " and ") + object.at("name").text();
  std::vector<BarPlot> plots;
  for (std::size_t i = 0; i < rows.size(); ++i)
    plots.push_back(
        cost_plot(workloads[i], rows[i],
                  fmt::format("{} of {}; of each volume the cheapest hierarchy", report.at("task").text(), objects)));
  return plot_svg(plots);
}

// --- benchmarks

/// What benchmarks measure, in the order in which it is looked for.
struct Field {
  const char* key;
  const char* name;
  double nanoseconds;
};
using Fields = std::vector<Field>;

const std::vector<Fields>& known_fields() {
  static const std::vector<Fields> known{
      Fields{{"median_us", "median", 1e3}, {"p99_us", "99 of 100 take less", 1e3}},
      Fields{{"median_ns", "median", 1}, {"p99_ns", "99 of 100 take less", 1}},
      Fields{{"median_ms", "median", 1e6}, {"worst_ms", "worst", 1e6}},
      Fields{{"build_ms", "to build", 1e6}},
      Fields{{"median_seconds", "median", 1e9}, {"worst_seconds", "worst", 1e9}},
      Fields{{"generic_median_us", "the walker", 1e3}, {"by_hand_median_us", "a loop by hand", 1e3}}};
  return known;
}

/// The first that any row has more than nothing of.
std::optional<Fields> fields_of(const std::vector<JsonValue>& results) {
  for (const Fields& fields : known_fields())
    for (const JsonValue& row : results)
      if (number_or_nan(row, fields[0].key) > 0) return fields;
  return std::nullopt;
}

double greatest_of(const std::vector<JsonValue>& results, const Fields& fields) {
  double greatest = 0;
  for (const JsonValue& row : results)
    for (const Field& field : fields) greatest = std::fmax(greatest, field.nanoseconds * number_or_nan(row, field.key));
  return greatest;
}

std::string who_of(const JsonValue& row) { return row.at("library").text() + ": " + row.text_or("variant", ""); }

double threads_of(const JsonValue& row) { return row.has("threads") ? row.at("threads").number() : 1; }

/// Whether several who were measured used more than one number of threads.
bool is_about_threads(const std::vector<JsonValue>& results) {
  constexpr std::ptrdiff_t few = 3;
  return std::any_of(results.begin(), results.end(), [&](const JsonValue& one) {
    return std::count_if(results.begin(), results.end(),
                         [&](const JsonValue& other) { return who_of(other) == who_of(one); }) >= few;
  });
}

std::string threads_svg(const std::vector<JsonValue>& results, const Field& field, const BarPlot& head,
                        const TimeUnit& unit) {
  LinePlot plot{head.title, head.subtitle, "threads", head.quantity, {}};
  for (const JsonValue& row : results) {
    auto line = std::find_if(plot.lines.begin(), plot.lines.end(),
                             [&](const PlotLine& known) { return known.name == who_of(row); });
    if (line == plot.lines.end()) line = plot.lines.insert(line, {who_of(row), {}});
    line->points.push_back({threads_of(row), number_or_nan(row, field.key) * field.nanoseconds / unit.nanoseconds});
  }
  return plot_svg(plot);
}

std::string bench_svg(const JsonValue& report) {
  const std::vector<JsonValue> results = report.at("results").elements();
  const std::optional<Fields> fields = fields_of(results);
  if (!fields) report.fail("there is no result with a time", "measure something");
  const TimeUnit unit = unit_for(greatest_of(results, *fields));
  BarPlot plot{fmt::format("{}: {}", report.at("benchmark").text(), results[0].text_or("task", "")),
               told(report.at("question")),
               fmt::format("{}{}", unit.name, (*fields)[0].key == std::string_view("build_ms") ? "" : " of a query"),
               {},
               {},
               {}};
  if (is_about_threads(results)) return threads_svg(results, (*fields)[0], plot, unit);
  for (const Field& field : *fields) plot.series.push_back({field.name, {}});
  for (const JsonValue& row : results) {
    plot.rows.push_back(who_of(row) + (threads_of(row) > 1 ? fmt::format(", {} threads", threads_of(row)) : ""));
    for (std::size_t i = 0; i < fields->size(); ++i)
      plot.series[i].values.push_back(number_or_nan(row, (*fields)[i].key) * (*fields)[i].nanoseconds /
                                      unit.nanoseconds);
  }
  return plot_svg(std::array{plot});
}

}  // namespace

std::string report_plot_svg(std::string_view json, const std::string& name) {
  const nlohmann::json document = io::parse_json(json, name, io::RepeatedKeys::refused);
  const JsonValue report(document, name);
  if (report.is_object() && report.text_or("schema", "") == "toccata/cost/1") return cost_svg(report);
  if (report.is_object() && report.text_or("format", "") == "toccata-bench-1") return bench_svg(report);
  report.fail("this is no report of `toccata cost --json` or of a benchmark", "make one, and name it");
}

}  // namespace toccata
