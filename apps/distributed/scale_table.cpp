#include "scale_table.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "run_ranks.hpp"
#include "scale_model.hpp"

namespace toccata {
namespace {

struct MeasuredScale {
  int ranks = 1;
  double milliseconds = 0;
  double apart = 0;      ///< of a step of as many Worlds at once, each of its own share of the boxes
  double processor = 0;  ///< of a rank, waiting included
  RankLoad load;
};

int size_of_world() {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

int rank_in_world() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

/// What the machine gives so many ranks at once that have nothing to do with each other.
double milliseconds_apart(int ranks, CrowdOfRanks crowd, MPI_Comm all) {
  crowd.count /= static_cast<std::size_t>(ranks);
  crowd.communicator = MPI_Comm_c2f(MPI_COMM_SELF);
  MPI_Barrier(all);
  const double own = costs_of_ranks(crowd).front().milliseconds;
  double most = own;
  MPI_Allreduce(&own, &most, 1, MPI_DOUBLE, MPI_MAX, all);
  return most;
}

/// On the first of all ranks; the others wait.
MeasuredScale measure_on(int ranks, CrowdOfRanks crowd) {
  MPI_Comm some = MPI_COMM_NULL;
  MPI_Comm_split(MPI_COMM_WORLD, rank_in_world() < ranks ? 0 : MPI_UNDEFINED, rank_in_world(), &some);
  MeasuredScale measured;
  measured.ranks = ranks;
  if (some != MPI_COMM_NULL) {
    crowd.communicator = MPI_Comm_c2f(some);
    const std::vector<RankCosts> rows = costs_of_ranks(crowd);
    for (const RankCosts& row : rows) {
      measured.milliseconds = std::max(measured.milliseconds, row.milliseconds);
      measured.processor += 1e3 * row.processor_seconds / static_cast<double>(crowd.frames * rows.size());
    }
    measured.apart = ranks > 1 ? milliseconds_apart(ranks, crowd, some) : measured.milliseconds;
    if (!rows.empty()) measured.load = average_load(rows, static_cast<double>(crowd.frames));
    MPI_Comm_free(&some);
  }
  wait_idly();
  return measured;
}

/// Ranks that share a core take turns.
double turns_at_a_core(int ranks) {
  return std::max(1., ranks / std::max(1., static_cast<double>(std::thread::hardware_concurrency())));
}

void print_measured(const std::vector<MeasuredScale>& all, const MachineCosts& machine) {
  fmt::print("{:>6}{:>15}{:>10}{:>11}{:>14}{:>13}{:>15}{:>15}{:>19}{:>13}{:>11}{:>14}\n", "ranks", "bodies a rank",
             "ghosts %", "imbalance", "bytes a rank", "measured ms", "foretold ms", "from 1 and 2", "a core each, ms",
             "processor ms", "apart ms", "times as fast");
  for (const MeasuredScale& one : all) {
    const double own_core = 1e3 * predicted_seconds(machine, one.load, one.ranks);
    const double turns = turns_at_a_core(one.ranks);
    fmt::print("{:>6}{:>15.0f}{:>10.2f}{:>11.3f}{:>14.0f}{:>13.2f}{:>15.2f}", one.ranks, one.load.bodies,
               100 * one.load.ghosts, one.load.imbalance, one.load.bytes, one.milliseconds, turns * own_core);
    if (one.ranks > 1)
      fmt::print(
          "{:>15.2f}",
          1e3 * turns * predicted_seconds(machine, load_from_two(all[1].load, one.load.bodies, one.ranks), one.ranks));
    else
      fmt::print("{:>15}", "");
    fmt::print("{:>19.2f}{:>13.2f}{:>11.2f}{:>14.2f}\n", own_core, one.processor, one.apart,
               all[0].milliseconds / std::max(one.milliseconds, 1e-9));
  }
}

void print_foretold(const RankLoad& of_two, const MachineCosts& machine) {
  fmt::print("{:>14}{:>7}{:>15}{:>10}{:>14}{:>14}{:>22}\n", "bodies", "ranks", "bodies a rank", "ghosts %",
             "bytes a rank", "foretold ms", "of one World alone, %");
  for (const auto& [bodies, ranks] : {std::pair(1e8, 64.), {1e8, 1024.}, {1e9, 1024.}}) {
    const RankLoad load = load_from_two(of_two, bodies / ranks, ranks);
    const double seconds = predicted_seconds(machine, load, ranks);
    fmt::print("{:>14.0f}{:>7.0f}{:>15.0f}{:>10.2f}{:>14.0f}{:>14.1f}{:>22.1f}\n", bodies, ranks, load.bodies,
               100 * load.ghosts, load.bytes, 1e3 * seconds, 100 * load.bodies * machine.seconds_a_body / seconds);
  }
}

}  // namespace

void print_scale(const std::string& scene, CrowdOfRanks crowd, const NetworkOfMany& network) {
  crowd.scene = scene;
  MachineCosts machine = measured_network();
  std::vector<MeasuredScale> all;
  for (int ranks = 1; ranks <= size_of_world(); ranks *= 2) all.push_back(measure_on(ranks, crowd));
  if (rank_in_world() != 0) return;
  machine.seconds_a_body = all[0].milliseconds / 1e3 / std::max(all[0].load.bodies, 1.);
  fmt::print("{}, {} boxes, the median of {} steps; one World takes {:.0f} ns a box", crowd.scene, crowd.count,
             crowd.frames, 1e9 * machine.seconds_a_body);
  if (all.size() > 1)
    fmt::print(
        "; between two ranks here {:.1f} µs a message, {:.1f} GB a second, and {:.1f} reductions and barriers a step",
        1e6 * machine.latency, machine.bandwidth / 1e9, all[1].load.collectives);
  fmt::print("\n");
  print_measured(all, machine);
  if (all.size() < 2) return;
  machine.latency = network.microseconds / 1e6;
  machine.bandwidth = network.gigabytes * 1e9;
  fmt::print("foretold with {} µs a message and {} GB a second, as assumed, from what 1 and 2 ranks took here\n",
             network.microseconds, network.gigabytes);
  print_foretold(all[1].load, machine);
}

}  // namespace toccata
