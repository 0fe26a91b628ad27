// mpirun -np N toccata-crowd-ranks --count 1000000: a crowd in a DistributedWorld, and what it costs each rank. A
// program of its own, so that the command needs no MPI.
#include <fmt/format.h>
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "toccata/distributed.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {
namespace {

struct Arguments {
  std::size_t count = 100'000;
  std::size_t frames = 10;
  std::string scene = "uniform";
  std::uint64_t seed = 1;
  int threads = own_thread;
};

/// Of one rank, for the table: sums over the frames but for the bodies, ghosts and pairs, which are those of the last.
struct Row {
  double milliseconds = 0;  ///< the median of a step
  double bodies = 0, ghosts = 0, pairs = 0, came = 0, bytes = 0, imbalance = 0, divisions = 0;
};

Vec3 middle_of(const Aabb& box) { return 0.5 * (box.lower + box.upper); }

/// A rank gives the bodies whose turn it is, whichever part of space they are in.
std::vector<GlobalBody> bodies_to_give(const Crowd& crowd, const DistributedWorld& world) {
  std::vector<GlobalBody> bodies;
  const auto ranks = static_cast<std::size_t>(world.rank_count());
  for (std::size_t i = static_cast<std::size_t>(world.rank()); i < crowd.boxes().size(); i += ranks) {
    const Aabb& box = crowd.boxes()[i];
    bodies.push_back({i, {Box(0.5 * (box.upper - box.lower)), Pose::translation(middle_of(box))}});
  }
  return bodies;
}

void move_those_here(Crowd& crowd, DistributedWorld& world) {
  std::vector<GlobalId> ids;
  std::vector<Pose> poses;
  for (const Index moved : crowd.step()) {
    if (!world.lives_here(moved)) continue;
    ids.push_back(moved);
    poses.push_back(Pose::translation(middle_of(crowd.boxes()[moved])));
  }
  world.move(ids, poses);
}

Row run(const Arguments& arguments) {
  DistributedOptions options;
  options.world.threads = arguments.threads;
  DistributedWorld world({MPI_Comm_c2f(MPI_COMM_WORLD)}, options);
  Crowd crowd(arguments.scene, arguments.count, arguments.seed);
  world.add(bodies_to_give(crowd, world));
  world.step();
  Row row;
  std::vector<double> milliseconds;
  for (std::size_t frame = 0; frame < arguments.frames; ++frame) {
    move_those_here(crowd, world);
    const auto begin = std::chrono::steady_clock::now();
    const DistributedCosts& costs = world.step().costs;
    milliseconds.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    row.bodies = static_cast<double>(costs.bodies);
    row.ghosts = static_cast<double>(costs.ghosts);
    row.came += static_cast<double>(costs.came);
    row.bytes += static_cast<double>(costs.bytes_sent);
    row.imbalance = costs.imbalance;
    row.divisions += costs.was_divided ? 1 : 0;
  }
  row.pairs = static_cast<double>(world.pairs().size());
  std::sort(milliseconds.begin(), milliseconds.end());
  row.milliseconds = milliseconds[milliseconds.size() / 2];
  return row;
}

void print_table(const Arguments& arguments, const std::vector<Row>& rows) {
  fmt::print("{} boxes, {}, {} frames, {} ranks; imbalance {:.2f}, space divided anew {} times\n", arguments.count,
             arguments.scene, arguments.frames, rows.size(), rows[0].imbalance, rows[0].divisions);
  fmt::print("{:>4}{:>12}{:>11}{:>10}{:>10}{:>11}{:>14}{:>14}\n", "rank", "ms a step", "bodies", "ghosts", "ghosts %",
             "pairs", "came a step", "bytes a step");
  const auto frames = static_cast<double>(arguments.frames);
  double pairs = 0;
  for (std::size_t rank = 0; rank < rows.size(); ++rank) {
    const Row& row = rows[rank];
    fmt::print("{:>4}{:>12.3f}{:>11}{:>10}{:>10.2f}{:>11}{:>14.1f}{:>14.0f}\n", rank, row.milliseconds, row.bodies,
               row.ghosts, 100 * row.ghosts / std::max(row.bodies, 1.0), row.pairs, row.came / frames,
               row.bytes / frames);
    pairs += row.pairs;
  }
  fmt::print("{} pairs in contact\n", pairs);
}

int main_of(int count, char** words) {
  Arguments arguments;
  CLI::App app("Boxes that move, divided over the ranks of mpirun: what a step takes, ghosts, and bytes sent.");
  std::vector<std::string> scenes;
  for (const NamedScene& scene : crowd_scenes()) scenes.push_back(scene.name);
  const auto positive = CLI::Range(std::uint64_t{1}, std::uint64_t{4'000'000'000});
  app.add_option("--count", arguments.count, "boxes of all ranks together")->check(positive)->capture_default_str();
  app.add_option("--frames", arguments.frames, "the median of their times is told")
      ->check(positive)
      ->capture_default_str();
  app.add_option("--scene", arguments.scene, "how they lie and move")
      ->check(CLI::IsMember(scenes))
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "another seed, another crowd")->capture_default_str();
  app.add_option("--threads", arguments.threads, "of each rank; 0: all that the machine has")->capture_default_str();
  CLI11_PARSE(app, count, words);
  const Row own = run(arguments);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<Row> rows(static_cast<std::size_t>(ranks));
  MPI_Gather(&own, sizeof(Row), MPI_BYTE, rows.data(), sizeof(Row), MPI_BYTE, 0, MPI_COMM_WORLD);
  if (rank == 0) print_table(arguments, rows);
  return 0;
}

}  // namespace
}  // namespace toccata

int main(int count, char** words) {
  int provided = 0;
  MPI_Init_thread(&count, &words, MPI_THREAD_FUNNELED, &provided);
  int code = 2;
  try {
    code = toccata::main_of(count, words);
  } catch (const std::exception& error) {
    // All ranks have the same to say, or are no longer there to be waited for.
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) fmt::print(stderr, "toccata-crowd-ranks: {}\n", error.what());
    MPI_Abort(MPI_COMM_WORLD, code);
  }
  MPI_Finalize();
  return code;
}
