#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "arguments.hpp"
#include "measure.hpp"
#include "mover_judge.hpp"
#include "movers.hpp"
#include "report.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

struct MoverRow {
  Description who;
  std::string level;
  double build_ms = 0;
  double median_us = 0;
  double mean_us = 0;
  double p99_us = 0;
  double worst_us = 0;
  WalkFaults faults{};
};

/// All walks once; the times of steps that were taken sooner than before are kept.
std::vector<WalkedFeet> walked(MoverLibrary& library, const WalkWork& work, std::vector<std::vector<double>>& fastest) {
  std::vector<WalkedFeet> all;
  for (std::size_t w = 0; w < work.walks.size(); ++w) {
    const Walk& walk = work.walks[w];
    library.place(walk.start);
    WalkedFeet feet{walk.start};
    for (std::size_t i = 0; i < walk.wishes.size(); ++i) {
      const double seconds = seconds_of([&] { library.step(walk.wishes[i]); }, Clock::thread);
      fastest[w][i] = std::min(fastest[w][i], 1e6 * seconds);
      feet.push_back(library.foot());
    }
    all.push_back(std::move(feet));
  }
  return all;
}

MoverRow measured(MoverLibrary& library, const WalkWork& work, const SceneIndex& level, int rounds) {
  MoverRow row{library.description(), work.level};
  row.build_ms = 1e3 * seconds_of([&] { library.build(work); }, Clock::thread);
  std::vector<std::vector<double>> fastest;
  for (const Walk& walk : work.walks)
    fastest.emplace_back(walk.wishes.size(), std::numeric_limits<double>::infinity());
  std::vector<WalkedFeet> feet;
  for (int round = 0; round < rounds; ++round) feet = walked(library, work, fastest);
  const std::vector<std::size_t> counted = counted_steps(work, level, feet);
  std::vector<double> times;
  for (std::size_t w = 0; w < fastest.size(); ++w)
    times.insert(times.end(), fastest[w].begin(), fastest[w].begin() + static_cast<std::ptrdiff_t>(counted[w]));
  row.worst_us = *std::max_element(times.begin(), times.end());
  Result summary;
  summarise(std::move(times), summary);
  row.median_us = summary.median_us;
  row.mean_us = summary.mean_us;
  row.p99_us = summary.p99_us;
  row.faults = judged_walks(work, level, feet);
  return row;
}

std::vector<MoverRow> rows_of(const WalkWork& work, const MoverArguments& arguments) {
  const SceneIndex level(work.models);
  MoverLibraries libraries = toccata_movers();
  if (!arguments.peers.empty())
    for (auto& library : bullet_movers()) libraries.push_back(std::move(library));
  std::vector<MoverRow> rows;
  for (const auto& library : libraries) rows.push_back(measured(*library, work, level, arguments.rounds));
  return rows;
}

bool is_toccata_wrong(const MoverRow& row) {
  return row.who.library == "toccata" && row.faults.catches + row.faults.overlaps + row.faults.tunnels > 0;
}

Json json_of(const MoverRow& row, double ratio) {
  return {{"library", row.who.library},         {"variant", row.who.variant},
          {"version", row.who.version},         {"level", row.level},
          {"steps", row.faults.steps},          {"median_us", row.median_us},
          {"mean_us", row.mean_us},             {"p99_us", row.p99_us},
          {"worst_us", row.worst_us},           {"ratio", ratio},
          {"build_ms", row.build_ms},           {"walked", row.faults.walked},
          {"catches", row.faults.catches},      {"lost", row.faults.lost},
          {"overlaps", row.faults.overlaps},    {"deepest", row.faults.deepest},
          {"tunnels", row.faults.tunnels}};
}

/// With the first of the level, which is Toccata's.
double ratio_of(const MoverRow& row, const std::vector<MoverRow>& rows) {
  return row.mean_us / std::find_if(rows.begin(), rows.end(), [&](const MoverRow& other) {
                         return other.level == row.level;
                       })->mean_us;
}

void print_table(const std::vector<MoverRow>& rows) {
  fmt::print("{:<9}{:<9}{:>8}{:>11}{:>9}{:>9}{:>10}{:>8}{:>9}{:>9}{:>9}{:>10}{:>9}{:>9}\n", "level", "library", "steps",
             "median us", "mean us", "p99 us", "worst us", "ratio", "walked", "catches", "lost %", "overlaps", "deepest",
             "tunnels");
  for (const MoverRow& row : rows) {
    const WalkFaults& faults = row.faults;
    fmt::print("{:<9}{:<9}{:>8}{:>11.2f}{:>9.2f}{:>9.1f}{:>10.1f}{:>8.2f}{:>9.1f}{:>9}{:>9.2f}{:>10}{:>9.4f}{:>9}\n",
               row.level, row.who.library, faults.steps, row.median_us, row.mean_us, row.p99_us, row.worst_us,
               ratio_of(row, rows), faults.walked, faults.catches, 100 * faults.lost, faults.overlaps, faults.deepest,
               faults.tunnels);
  }
  fmt::print("ratio: of the means, how many times as long as toccata; catches and lost: of seams alone\n");
}

std::vector<WalkWork> works_of(const MoverArguments& arguments) {
  const std::size_t walks = arguments.walks, steps = arguments.steps;
  std::vector<WalkWork> works;
  if (!arguments.mesh.empty()) {
    works.push_back(walk_work_at(arguments.mesh, arguments.scale, walks, steps, arguments.seed));
    return works;
  }
  for (const std::string& level : arguments.levels)
    works.push_back(walk_work(level, arguments.triangles, walks, steps, arguments.seed));
  return works;
}

}  // namespace

int run_mover(const MoverArguments& arguments) {
  std::vector<MoverRow> rows;
  for (const WalkWork& work : works_of(arguments))
    for (MoverRow& row : rows_of(work, arguments)) rows.push_back(std::move(row));
  const bool is_wrong = std::any_of(rows.begin(), rows.end(), is_toccata_wrong);
  if (arguments.json) {
    Json report = report_of("mover", {{"triangles", arguments.triangles},
                                      {"mesh", arguments.mesh},
                                      {"walks", arguments.walks},
                                      {"steps", arguments.steps},
                                      {"seed", arguments.seed},
                                      {"rounds", arguments.rounds}});
    report["results"] = Json::array();
    for (const MoverRow& row : rows) report["results"].push_back(json_of(row, ratio_of(row, rows)));
    fmt::print("{}\n", report.dump(2));
  } else {
    print_table(rows);
  }
  if (is_wrong) fmt::print(stderr, "toccata-bench: steps of Toccata's are wrong\n");
  return is_wrong ? 1 : 0;
}

}  // namespace toccata::bench
