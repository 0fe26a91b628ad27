#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "measure.hpp"
#include "pair_lists.hpp"
#include "parts.hpp"
#include "report.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

struct PartsRow {
  Description who;
  int threads = 1;
  double median_ms = 0;
  std::vector<IndexPair> pairs{};
  std::size_t missing = 0;
  std::size_t invented = 0;
};

PartsRow measured(PartsLibrary& library, std::span<const SceneInstance> parts, int threads, int rounds) {
  PartsRow row{library.description(), threads};
  library.build(parts);
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round)
    times.push_back(1e3 * seconds_of([&] { row.pairs = library.pairs(); }, threads == 1 ? Clock::thread : Clock::wall));
  std::sort(times.begin(), times.end());
  row.median_ms = times[times.size() / 2];
  std::sort(row.pairs.begin(), row.pairs.end());
  return row;
}

std::vector<PartsRow> rows_of(const PartsArguments& arguments) {
  std::vector<SceneInstance> parts = scene_models(many_parts(arguments.count, arguments.seed));
  for (SceneInstance& part : parts) part.solid = Solid::none;
  std::vector<PartsRow> rows;
  for (const auto& library : toccata_parts(arguments.threads))
    rows.push_back(measured(*library, parts, rows.empty() ? arguments.threads : 1, arguments.rounds));
  if (!arguments.peers.empty())
    for (const auto& library : fcl_parts()) rows.push_back(measured(*library, parts, 1, arguments.rounds));
  const std::vector<IndexPair>& truth = rows[1].pairs;  // of every pair
  for (PartsRow& row : rows) {
    row.missing = count_without(truth, row.pairs);
    row.invented = count_without(row.pairs, truth);
  }
  return rows;
}

Json json_of(const PartsRow& row, const PartsRow& first) {
  return {{"library", row.who.library}, {"variant", row.who.variant}, {"version", row.who.version},
          {"threads", row.threads},     {"median_ms", row.median_ms}, {"ratio", row.median_ms / first.median_ms},
          {"pairs", row.pairs.size()},  {"missing", row.missing},     {"invented", row.invented}};
}

void print_table(const std::vector<PartsRow>& rows) {
  fmt::print("{:<9}{:<26}{:>8}{:>12}{:>9}{:>9}{:>9}{:>10}\n", "library", "variant", "threads", "median ms", "ratio",
             "pairs", "missing", "invented");
  for (const PartsRow& row : rows)
    fmt::print("{:<9}{:<26}{:>8}{:>12.3f}{:>9.2f}{:>9}{:>9}{:>10}\n", row.who.library, row.who.variant, row.threads,
               row.median_ms, row.median_ms / rows.front().median_ms, row.pairs.size(), row.missing, row.invented);
  for (const PartsRow& row : rows) fmt::print("  {} {}: {}\n", row.who.library, row.who.version, row.who.flags);
}

}  // namespace

int run_parts(const PartsArguments& arguments) {
  const std::vector<PartsRow> rows = rows_of(arguments);
  if (arguments.json) {
    Json report = report_of("parts", {{"count", arguments.count}, {"seed", arguments.seed}});
    report["results"] = Json::array();
    for (const PartsRow& row : rows) report["results"].push_back(json_of(row, rows.front()));
    fmt::print("{}\n", report.dump(2));
  } else {
    print_table(rows);
  }
  return rows.front().missing + rows.front().invented > 0 ? 1 : 0;
}

}  // namespace toccata::bench
