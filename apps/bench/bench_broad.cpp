#include <fmt/format.h>

#include <algorithm>

#include "broad_race.hpp"
#include "report.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const BroadRow& row, const BroadRow& first) {
  return {{"library", row.who.library},
          {"variant", row.who.variant},
          {"version", row.who.version},
          {"threads", row.threads},
          {"frames", row.frames},
          {"median_ms", row.median_ms},
          {"mean_ms", row.mean_ms},
          {"worst_ms", row.worst_ms},
          {"ratio", row.median_ms / first.median_ms},
          {"pairs", row.pairs},
          {"bytes_per_body", row.bytes_per_body},
          {"wrong_frames", row.wrong_frames},
          {"reason", row.reason}};
}

void print_table(const std::vector<BroadRow>& rows) {
  fmt::print("{:<9}{:<25}{:>8}{:>8}{:>12}{:>12}{:>12}{:>8}{:>9}{:>11}{:>9}{:>13}\n", "library", "variant", "threads",
             "frames", "median ms", "mean ms", "worst ms", "worst/m", "ratio", "pairs", "B/body", "wrong frames");
  for (const BroadRow& row : rows)
    fmt::print("{:<9}{:<25}{:>8}{:>8}{:>12.3f}{:>12.3f}{:>12.3f}{:>8.2f}{:>9.2f}{:>11}{:>9.0f}{:>13}\n",
               row.who.library, row.who.variant, row.threads, row.frames, row.median_ms, row.mean_ms, row.worst_ms,
               row.worst_ms / row.median_ms, row.median_ms / rows.front().median_ms, row.pairs, row.bytes_per_body,
               row.wrong_frames);
  for (const BroadRow& row : rows)
    if (!row.reason.empty()) fmt::print("  {} {}: {}\n", row.who.library, row.who.variant, row.reason);
  for (const BroadRow& row : rows) fmt::print("  {} {}: {}\n", row.who.library, row.who.version, row.who.flags);
}

int run_scene(const BroadArguments& arguments) {
  const BroadTruth truth = true_pairs(arguments);
  std::vector<BroadRow> rows;
  for (auto& library : toccata_broad_libraries(arguments.methods, arguments.threads)) {
    rows.push_back(measured(*library, arguments, truth, arguments.seconds));
    library.reset();
  }
  for (auto& library : peers_asked(arguments)) {
    rows.push_back(measured_apart(*library, arguments, truth, arguments.seconds));
    library.reset();
  }
  if (arguments.json) {
    Json report = report_of("broad", {{"scene", arguments.scene},
                                      {"count", arguments.count},
                                      {"frames", arguments.frames},
                                      {"seed", arguments.seed},
                                      {"truth", truth.how}});
    report["results"] = Json::array();
    for (const BroadRow& row : rows) report["results"].push_back(json_of(row, rows.front()));
    fmt::print("{}\n", report.dump(2));
  } else {
    print_table(rows);
    fmt::print("  answers compared with {}\n", truth.how);
  }
  return std::any_of(rows.begin(), rows.end(),
                     [](const BroadRow& row) { return row.who.library == "toccata" && row.wrong_frames > 0; })
             ? 1
             : 0;
}

}  // namespace

int run_broad(const BroadArguments& arguments) {
  if (arguments.task == "table") return run_broad_table(arguments);
  if (arguments.task == "cell-size") return run_broad_cell_size(arguments);
  if (arguments.task == "swaps") return run_broad_swaps(arguments);
  return run_scene(arguments);
}

}  // namespace toccata::bench
