#include <fmt/format.h>

#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata::command {
namespace {

std::string_view name_of(PairState state) { return state == PairState::defined ? "defined" : "not defined"; }

std::string first_name(ShapeQuestion question, ShapeKind a) {
  return std::string(question == ShapeQuestion::cast_ray ? "ray" : toccata::name_of(a));
}

/// What a question says of a shape and others; a ray is cast at others alone.
struct Row {
  ShapeQuestion question{};
  std::vector<std::string> a;
  std::vector<std::string> b;
  PairCell cell;
};

std::vector<Row> rows_of(ShapeQuestion question, ShapeKind a) {
  std::vector<Row> rows;
  for (std::size_t j = 0; j < shape_kind_count; ++j) {
    const auto b = static_cast<ShapeKind>(j);
    const PairCell cell = pair_cell(question, a, b);
    const auto same =
        std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.cell.text == cell.text; });
    if (same != rows.end())
      same->b.emplace_back(toccata::name_of(b));
    else
      rows.push_back({question, {first_name(question, a)}, {std::string(toccata::name_of(b))}, cell});
  }
  return rows;
}

/// All of a question, shapes of which the same is said in one row.
std::vector<Row> rows_of(ShapeQuestion question) {
  std::vector<Row> all;
  for (std::size_t i = 0; i < (question == ShapeQuestion::cast_ray ? 1 : shape_kind_count); ++i)
    for (const Row& row : rows_of(question, static_cast<ShapeKind>(i))) {
      const auto same = std::find_if(all.begin(), all.end(), [&](const Row& other) {
        return other.cell.text == row.cell.text && other.b == row.b;
      });
      if (same != all.end())
        same->a.push_back(row.a.front());
      else
        all.push_back(row);
    }
  return all;
}

std::vector<Row> all_rows() {
  std::vector<Row> rows;
  for (std::size_t q = 0; q < question_count; ++q)
    for (Row& row : rows_of(static_cast<ShapeQuestion>(q))) rows.push_back(std::move(row));
  return rows;
}

std::string pairs_json() {
  nlohmann::ordered_json json = {{"schema", "toccata/pairs/1"}, {"version", version}};
  auto& rows = json["rows"] = nlohmann::ordered_json::array();
  for (const Row& row : all_rows())
    rows.push_back({{"question", toccata::name_of(row.question)},
                    {"a", row.a},
                    {"b", row.b},
                    {"state", name_of(row.cell.state)},
                    {"text", row.cell.text}});
  return json.dump(1) + "\n";
}

std::string pairs_table() {
  std::string text = "| question | of one of | and one of | is | how, or why not |\n|---|---|---|---|---|\n";
  for (const Row& row : all_rows())
    text += fmt::format("| {} | {} | {} | {} | {} |\n", toccata::name_of(row.question), fmt::join(row.a, ", "),
                        fmt::join(row.b, ", "), name_of(row.cell.state), row.cell.text);
  return text;
}

int run_pairs(Format format) {
  print_answer(format == Format::json ? pairs_json() : pairs_table());
  return 0;
}

}  // namespace

Subcommand add_pairs(CLI::App& app) {
  const auto arguments = std::make_shared<Format>();
  CLI::App* pairs = app.add_subcommand("pairs", "which questions are answered about which shapes, and why not");
  add_json(*pairs, *arguments, "write JSON (docs/reference/pairs.md)");
  pairs->footer(with_name("Example:\n  {0} pairs"));
  return {pairs, [arguments] { return run_pairs(*arguments); }};
}

}  // namespace toccata::command
