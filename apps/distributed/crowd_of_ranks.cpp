// mpirun -np N toccata-crowd-ranks --count 1000000: a crowd in a DistributedWorld, and what it costs each rank. A
// program of its own, so that the command needs no MPI.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "crowd_run.hpp"
#include "number_checks.hpp"
#include "run_ranks.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {
namespace {

void print_table(const CrowdOfRanks& arguments, const std::vector<RankCosts>& rows) {
  fmt::print("{} boxes, {}, {} frames, {} ranks; imbalance {:.2f}, space divided anew {} times\n", arguments.count,
             arguments.scene, arguments.frames, rows.size(), rows[0].imbalance, rows[0].divisions);
  fmt::print("{:>4}{:>12}{:>12}{:>11}{:>10}{:>10}{:>11}{:>11}{:>14}{:>14}{:>11}\n", "rank", "ms a step", "ms waiting",
             "bodies", "ghosts", "ghosts %", "pairs", "looked at", "came a step", "bytes a step", "memory MB");
  const auto frames = static_cast<double>(arguments.frames);
  double pairs = 0;
  for (std::size_t rank = 0; rank < rows.size(); ++rank) {
    const RankCosts& row = rows[rank];
    fmt::print("{:>4}{:>12.3f}{:>12.3f}{:>11}{:>10}{:>10.2f}{:>11}{:>11}{:>14.1f}{:>14.0f}{:>11.0f}\n", rank,
               row.milliseconds, 1e3 * row.seconds.waiting / frames, row.bodies, row.ghosts,
               100 * row.ghosts / std::max(row.bodies, 1.0), row.pairs, row.candidates, row.came / frames,
               row.bytes / frames, row.peak_bytes / 1e6);
    pairs += row.pairs;
  }
  fmt::print("{} pairs in contact\n", pairs);
}

int main_of(int count, char** words) {
  CrowdOfRanks arguments;
  CLI::App app("Boxes that move, divided over the ranks of mpirun: what a step takes, ghosts, and bytes sent.");
  std::vector<std::string> scenes;
  for (const NamedScene& scene : crowd_scenes()) scenes.push_back(scene.name);
  const auto positive = whole_number(1, 4'000'000'000);
  app.add_option("--count", arguments.count, "boxes of all ranks together")->check(positive)->capture_default_str();
  app.add_option("--frames", arguments.frames, "the median of their times is told")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--scene", arguments.scene, "how they lie and move")
      ->check(CLI::IsMember(scenes))
      ->capture_default_str();
  app.add_option("--moving", arguments.moving, "which share of the boxes may move; the others stay")
      ->check(number_between(0, 1))
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "another seed, another crowd")->capture_default_str();
  app.add_option("--threads", arguments.threads, "of each rank; 0: all that the machine has")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  if (const std::optional<int> code = end_by_words(app, count, words)) return *code;
  const std::vector<RankCosts> rows = costs_of_ranks(arguments);
  if (!rows.empty()) print_table(arguments, rows);
  return 0;
}

}  // namespace
}  // namespace toccata

int main(int count, char** words) {
  return toccata::run_ranks(count, words, "toccata-crowd-ranks", [&] { return toccata::main_of(count, words); });
}
