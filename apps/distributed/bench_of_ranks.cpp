// mpirun -np N toccata-bench-ranks: what a step costs on these ranks, of each scene, and how good the planes divide it
// beside Zoltan's bisection and curve.
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "crowd_run.hpp"
#include "number_checks.hpp"
#include "partition_race.hpp"
#include "run_ranks.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {
namespace {

struct Arguments {
  CrowdOfRanks crowd;
  std::vector<std::string> scenes;
};

/// Of all ranks: what the slowest takes, and averages of one.
struct Line {
  std::string scene;
  double milliseconds = 0, ghosts = 0, imbalance = 0, candidates = 0, came = 0, bytes = 0, most_bytes = 0,
         divisions = 0;
};

Line line_of(const std::string& scene, const std::vector<RankCosts>& rows, double frames) {
  Line line{scene};
  double bodies = 0;
  for (const RankCosts& row : rows) {
    line.milliseconds = std::max(line.milliseconds, row.milliseconds);
    bodies += row.bodies;
    line.ghosts += row.ghosts;
    line.candidates += row.candidates;
    line.came += row.came / frames;
    line.bytes += row.bytes / frames / static_cast<double>(rows.size());
    line.most_bytes = std::max(line.most_bytes, row.bytes / frames);
  }
  line.ghosts /= std::max(bodies, 1.0);
  line.came /= std::max(bodies, 1.0);
  line.imbalance = rows[0].imbalance;
  line.divisions = rows[0].divisions;
  return line;
}

void print_steps(const Arguments& arguments, const std::vector<Line>& lines, int ranks) {
  fmt::print("{} ranks, {} boxes, the median of {} steps\n", ranks, arguments.crowd.count, arguments.crowd.frames);
  fmt::print("{:<12}{:>12}{:>10}{:>11}{:>13}{:>12}{:>15}{:>15}{:>9}\n", "scene", "ms a step", "ghosts %", "imbalance",
             "pairs seen", "moved in %", "bytes a rank", "of the most", "divided");
  for (const Line& line : lines)
    fmt::print("{:<12}{:>12.2f}{:>10.2f}{:>11.3f}{:>13}{:>12.3f}{:>15.0f}{:>15.0f}{:>9}\n", line.scene,
               line.milliseconds, 100 * line.ghosts, line.imbalance, line.candidates, 100 * line.came, line.bytes,
               line.most_bytes, line.divisions);
}

void print_partitions(const std::vector<std::pair<std::string, std::vector<PartitionQuality>>>& races) {
  fmt::print("{:<12}{:<16}{:>12}{:>11}{:>10}{:>14}\n", "scene", "divided by", "ms", "imbalance", "ghosts %",
             "% of a part");
  for (const auto& [scene, qualities] : races)
    for (const PartitionQuality& one : qualities)
      fmt::print("{:<12}{:<16}{:>12.2f}{:>11.3f}{:>10.2f}{:>14.2f}\n", scene, one.name, 1000 * one.seconds,
                 one.imbalance, 100 * one.ghosts, 100 * one.most_ghosts);
}

int main_of(int count, char** words) {
  Arguments arguments;
  arguments.crowd.count = 20'000;
  CLI::App app("What steps of crowds cost on the ranks of mpirun, and how their space is divided.");
  std::vector<std::string> all;
  for (const NamedScene& scene : crowd_scenes()) all.push_back(scene.name);
  const auto positive = whole_number(1, 4'000'000'000);
  app.add_option("--count", arguments.crowd.count, "boxes of all ranks together")
      ->check(whole_number(100, 4'000'000'000))
      ->capture_default_str();
  app.add_option("--frames", arguments.crowd.frames, "the median of their times is told")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--scene", arguments.scenes, "one or more; all, if none is named")->check(CLI::IsMember(all));
  app.add_option("--threads", arguments.crowd.threads, "of each rank; 0: all that the machine has")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  if (const std::optional<int> code = end_by_words(app, count, words)) return *code;
  if (arguments.scenes.empty()) arguments.scenes = all;
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<Line> lines;
  std::vector<std::pair<std::string, std::vector<PartitionQuality>>> races;
  for (const std::string& scene : arguments.scenes) {
    arguments.crowd.scene = scene;
    const std::vector<RankCosts> rows = costs_of_ranks(arguments.crowd);
    if (rank == 0) lines.push_back(line_of(scene, rows, static_cast<double>(arguments.crowd.frames)));
    const Crowd crowd(scene, arguments.crowd.count, arguments.crowd.seed);
    if (ranks > 1) races.emplace_back(scene, partition_qualities(crowd.boxes()));
  }
  if (rank != 0) return 0;
  print_steps(arguments, lines, ranks);
  if (ranks > 1) print_partitions(races);
  return 0;
}

}  // namespace
}  // namespace toccata

int main(int count, char** words) {
  return toccata::run_ranks(count, words, "toccata-bench-ranks", [&] { return toccata::main_of(count, words); });
}
