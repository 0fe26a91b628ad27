// mpirun -np N toccata-bench-ranks: what a step costs on these ranks, of each scene, and how good the planes divide it
// beside Zoltan's bisection and curve; and with --scale what a model foretells for more ranks.
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "crowd_run.hpp"
#include "nearest_race.hpp"
#include "number_checks.hpp"
#include "partition_race.hpp"
#include "run_ranks.hpp"
#include "scale_table.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {
namespace {

struct Arguments {
  CrowdOfRanks crowd;
  std::vector<std::string> scenes;
  std::size_t questions = 200;
  std::size_t nearest = 8;
  bool scale = false;
  NetworkOfMany network;
};

/// A line is about all ranks: what the slowest takes, and averages of one.
struct Line {
  std::string scene;
  double milliseconds = 0, ghosts = 0, imbalance = 0, candidates = 0, came = 0, bytes = 0, most_bytes = 0,
         bytes_of_bound = 0, most_of_bound = 0, divisions = 0, peak_bytes = 0, processor_seconds = 0;
  DistributedSeconds seconds{};  ///< of an average step and rank
  NearestRates nearest{};
};

DistributedSeconds average_seconds(const std::vector<RankCosts>& rows, double frames) {
  DistributedSeconds average;
  for (const auto part : {&DistributedSeconds::changes, &DistributedSeconds::division, &DistributedSeconds::sending,
                          &DistributedSeconds::receiving, &DistributedSeconds::pairs, &DistributedSeconds::telling,
                          &DistributedSeconds::waiting})
    for (const RankCosts& row : rows) average.*part += row.seconds.*part / frames / static_cast<double>(rows.size());
  return average;
}

Line line_of(const std::string& scene, const std::vector<RankCosts>& rows, double frames) {
  Line line{scene};
  double bodies = 0, bound = 0;
  for (const RankCosts& row : rows) {
    line.milliseconds = std::max(line.milliseconds, row.milliseconds);
    bodies += row.bodies;
    bound += row.bytes_bound / frames / static_cast<double>(rows.size());
    line.ghosts += row.ghosts;
    line.candidates += row.candidates;
    line.came += row.came / frames;
    line.bytes += row.bytes / frames / static_cast<double>(rows.size());
    line.most_bytes = std::max(line.most_bytes, row.bytes / frames);
    line.most_of_bound = std::max(line.most_of_bound, row.most_bytes_of_bound);
    line.peak_bytes = std::max(line.peak_bytes, row.peak_bytes);
    line.processor_seconds += row.processor_seconds / frames / static_cast<double>(rows.size());
  }
  line.ghosts /= std::max(bodies, 1.0);
  line.came /= std::max(bodies, 1.0);
  line.bytes_of_bound = line.bytes / std::max(bound, 1.0);
  line.imbalance = rows[0].imbalance;
  line.divisions = rows[0].divisions;
  line.seconds = average_seconds(rows, frames);
  return line;
}

void print_steps(const Arguments& arguments, const std::vector<Line>& lines, int ranks) {
  fmt::print("{} ranks, {} boxes of which {} % may move, the median of {} steps\n", ranks, arguments.crowd.count,
             100 * arguments.crowd.moving, arguments.crowd.frames);
  fmt::print("{:<12}{:>12}{:>10}{:>11}{:>13}{:>12}{:>15}{:>15}{:>9}\n", "scene", "ms a step", "ghosts %", "imbalance",
             "pairs seen", "moved in %", "bytes a rank", "of the most", "divided");
  for (const Line& line : lines)
    fmt::print("{:<12}{:>12.2f}{:>10.2f}{:>11.3f}{:>13}{:>12.3f}{:>15.0f}{:>15.0f}{:>9}\n", line.scene,
               line.milliseconds, 100 * line.ghosts, line.imbalance, line.candidates, 100 * line.came, line.bytes,
               line.most_bytes, line.divisions);
}

/// Where the time goes, and how much of what may be sent is.
void print_parts(const std::vector<Line>& lines) {
  fmt::print(
      "\nof an average step and rank in ms; migration: division, sending and receiving; the bound: 100 bytes a ghost "
      "and "
      "4 KiB a neighbour, of the average and of the worst rank and step; memory: of the program so far; processor: its "
      "time, also while it waits\n");
  fmt::print("{:<12}{:>9}{:>10}{:>9}{:>11}{:>9}{:>9}{:>9}{:>13}{:>9}{:>10}{:>11}{:>11}\n", "scene", "changes",
             "division", "sending", "receiving", "pairs", "telling", "waiting", "migration %", "bound %", "at most %",
             "memory MB", "processor");
  for (const Line& line : lines) {
    const DistributedSeconds& s = line.seconds;
    fmt::print(
        "{:<12}{:>9.2f}{:>10.2f}{:>9.2f}{:>11.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>13.1f}{:>9.1f}{:>10.1f}{:>11.0f}{:>11.2f}"
        "\n",
        line.scene, 1e3 * s.changes, 1e3 * s.division, 1e3 * s.sending, 1e3 * s.receiving, 1e3 * s.pairs,
        1e3 * s.telling, 1e3 * s.waiting, 100 * migration(s) / std::max(total(s), 1e-9), 100 * line.bytes_of_bound,
        100 * line.most_of_bound, line.peak_bytes / 1e6, 1e3 * line.processor_seconds);
  }
}

void print_nearest(const Arguments& arguments, const std::vector<Line>& lines) {
  fmt::print("\nthe {} nearest boxes, questions a second of {} a rank: the answers are the same\n", arguments.nearest,
             arguments.questions);
  fmt::print("{:<12}{:>16}{:>16}{:>18}{:>10}\n", "scene", "one rank alone", "a rank of all", "without waiting",
             "ratio");
  for (const Line& line : lines)
    fmt::print("{:<12}{:>16.0f}{:>16.0f}{:>18.0f}{:>10.2f}\n", line.scene, line.nearest.alone, line.nearest.of_a_rank,
               line.nearest.without_waiting, line.nearest.without_waiting / std::max(line.nearest.alone, 1e-9));
}

void print_partitions(const std::vector<std::pair<std::string, std::vector<PartitionQuality>>>& races) {
  fmt::print("\n{:<12}{:<16}{:>12}{:>11}{:>10}{:>14}\n", "scene", "divided by", "ms", "imbalance", "ghosts %",
             "% of a part");
  for (const auto& [scene, qualities] : races)
    for (const PartitionQuality& one : qualities)
      fmt::print("{:<12}{:<16}{:>12.2f}{:>11.3f}{:>10.2f}{:>14.2f}\n", scene, one.name, 1000 * one.seconds,
                 one.imbalance, 100 * one.ghosts, 100 * one.most_ghosts);
}

void add_options(CLI::App& app, Arguments& arguments, const std::vector<std::string>& scenes) {
  app.add_option("--count", arguments.crowd.count, "boxes of all ranks together")
      ->check(whole_number(100, 4'000'000'000))
      ->capture_default_str();
  app.add_option("--frames", arguments.crowd.frames, "the median of their times is told")
      ->check(whole_number(1, 4'000'000'000))
      ->capture_default_str();
  app.add_option("--scene", arguments.scenes, "one or more; all, if none is named, and with --scale the first")
      ->check(CLI::IsMember(scenes));
  app.add_option("--moving", arguments.crowd.moving, "which share of the boxes may move; the others stay")
      ->check(number_between(0, 1))
      ->capture_default_str();
  CLI::Option* scale =
      app.add_flag("--scale", arguments.scale, "instead: 1, 2, 4, … of these ranks, beside what a model foretells");
  app.add_option("--questions", arguments.questions, "of each rank, for its nearest boxes; 0: none")
      ->excludes(scale)
      ->check(whole_number(0, 100'000'000))
      ->capture_default_str();
  app.add_option("--nearest", arguments.nearest, "how many boxes are wanted")
      ->excludes(scale)
      ->check(whole_number(1, 100'000))
      ->capture_default_str();
  app.add_option("--threads", arguments.crowd.threads, "of each rank; 0: all that the machine has")
      ->check(whole_number(0, 1024))
      ->capture_default_str();
  app.add_option("--latency", arguments.network.microseconds, "of --scale, of many machines: µs of a message")
      ->needs(scale)
      ->check(number_above_0())
      ->capture_default_str();
  app.add_option("--bandwidth", arguments.network.gigabytes, "of --scale, of many machines: GB a second")
      ->needs(scale)
      ->check(number_above_0())
      ->capture_default_str();
}

void run_scenes(Arguments& arguments, int rank, int ranks) {
  std::vector<Line> lines;
  std::vector<std::pair<std::string, std::vector<PartitionQuality>>> races;
  for (const std::string& scene : arguments.scenes) {
    arguments.crowd.scene = scene;
    const std::vector<RankCosts> rows = costs_of_ranks(arguments.crowd);
    NearestRates nearest;
    if (arguments.questions > 0) nearest = nearest_rates(arguments.crowd, arguments.questions, arguments.nearest);
    if (rank == 0) {
      lines.push_back(line_of(scene, rows, static_cast<double>(arguments.crowd.frames)));
      lines.back().nearest = nearest;
    }
    const Crowd crowd(scene, arguments.crowd.count, arguments.crowd.seed);
    if (ranks > 1) races.emplace_back(scene, partition_qualities(crowd.boxes()));
  }
  if (rank != 0) return;
  print_steps(arguments, lines, ranks);
  print_parts(lines);
  if (arguments.questions > 0) print_nearest(arguments, lines);
  if (ranks > 1) print_partitions(races);
}

int main_of(int count, char** words) {
  Arguments arguments;
  arguments.crowd.count = 20'000;
  CLI::App app("What steps of crowds cost on the ranks of mpirun, and how their space is divided.");
  std::vector<std::string> all;
  for (const NamedScene& scene : crowd_scenes()) all.push_back(scene.name);
  add_options(app, arguments, all);
  if (const std::optional<int> code = end_by_words(app, count, words)) return *code;
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (arguments.scenes.empty()) arguments.scenes = arguments.scale ? std::vector{arguments.crowd.scene} : all;
  if (arguments.scale)
    for (const std::string& scene : arguments.scenes) print_scale(scene, arguments.crowd, arguments.network);
  else
    run_scenes(arguments, rank, ranks);
  return 0;
}

}  // namespace
}  // namespace toccata

int main(int count, char** words) {
  return toccata::run_ranks(count, words, "toccata-bench-ranks", [&] { return toccata::main_of(count, words); });
}
