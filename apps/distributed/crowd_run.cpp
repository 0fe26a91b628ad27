#include "crowd_run.hpp"

#include <mpi.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>

#include "toccata/core/random.hpp"

namespace toccata {
namespace {

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

void move_those_here(Crowd& crowd, const CrowdOfRanks& wanted, DistributedWorld& world) {
  std::vector<GlobalId> ids;
  std::vector<Pose> poses;
  for (const Index moved : crowd.step()) {
    if (!world.lives_here(moved)) continue;
    if (wanted.moving < 1 && Random(wanted.seed + moved).unit() >= wanted.moving) continue;
    ids.push_back(moved);
    poses.push_back(Pose::translation(middle_of(crowd.boxes()[moved])));
  }
  world.move(ids, poses);
}

void add(DistributedSeconds& sum, const DistributedSeconds& one) {
  sum.changes += one.changes;
  sum.division += one.division;
  sum.sending += one.sending;
  sum.receiving += one.receiving;
  sum.pairs += one.pairs;
  sum.telling += one.telling;
  sum.waiting += one.waiting;
}

void add(RankCosts& row, const DistributedCosts& costs) {
  row.bodies = static_cast<double>(costs.bodies);
  row.ghosts = static_cast<double>(costs.ghosts);
  row.candidates = static_cast<double>(costs.candidates);
  row.came += static_cast<double>(costs.came);
  row.bytes += static_cast<double>(costs.bytes_sent);
  row.bytes_bound += bound_of_bytes(costs);
  row.most_bytes_of_bound =
      std::max(row.most_bytes_of_bound, static_cast<double>(costs.bytes_sent) / std::max(bound_of_bytes(costs), 1.));
  row.imbalance = costs.imbalance;
  row.divisions += costs.was_divided ? 1 : 0;
  row.collectives += static_cast<double>(costs.collectives);
  add(row.seconds, costs.seconds);
}

rusage used_by_this() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used;
}

double processor_seconds() {
  const rusage used = used_by_this();
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

MPI_Comm communicator_of(const CrowdOfRanks& wanted) {
  return MPI_Comm_f2c(wanted.communicator.value_or(MPI_Comm_c2f(MPI_COMM_WORLD)));
}

RankCosts costs_of_this(const CrowdOfRanks& wanted) {
  Crowd crowd(wanted.scene, wanted.count, wanted.seed);
  DistributedWorld world = world_of_crowd(crowd, wanted);
  RankCosts row;
  std::vector<double> milliseconds;
  for (std::size_t frame = 0; frame < wanted.frames; ++frame) {
    move_those_here(crowd, wanted, world);
    // Each rank moves the whole crowd to know its own: who is through earlier is not to wait for that in the step.
    MPI_Barrier(communicator_of(wanted));
    const double processor_before = processor_seconds();
    const auto begin = std::chrono::steady_clock::now();
    const DistributedCosts& costs = world.step().costs;
    milliseconds.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    row.processor_seconds += processor_seconds() - processor_before;
    add(row, costs);
  }
  row.pairs = static_cast<double>(world.pairs().size());
  row.peak_bytes = 1024. * static_cast<double>(used_by_this().ru_maxrss);
  std::sort(milliseconds.begin(), milliseconds.end());
  row.milliseconds = milliseconds[milliseconds.size() / 2];
  return row;
}

}  // namespace

double bound_of_bytes(const DistributedCosts& costs) {
  return 100. * static_cast<double>(costs.ghosts_elsewhere) + 4096. * static_cast<double>(costs.neighbours);
}

double total(const DistributedSeconds& seconds) {
  return seconds.changes + seconds.pairs + seconds.telling + migration(seconds);
}

double migration(const DistributedSeconds& seconds) { return seconds.division + seconds.sending + seconds.receiving; }

DistributedWorld world_of_crowd(const Crowd& crowd, const CrowdOfRanks& wanted) {
  DistributedOptions options;
  options.world.threads = wanted.threads;
  DistributedWorld world({wanted.communicator.value_or(MPI_Comm_c2f(MPI_COMM_WORLD))}, options);
  world.add(bodies_to_give(crowd, world));
  world.step();
  return world;
}

std::vector<RankCosts> costs_of_ranks(const CrowdOfRanks& crowd) {
  const RankCosts own = costs_of_this(crowd);
  MPI_Comm communicator = communicator_of(crowd);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(communicator, &rank);
  MPI_Comm_size(communicator, &ranks);
  std::vector<RankCosts> rows(static_cast<std::size_t>(ranks));
  MPI_Gather(&own, sizeof(RankCosts), MPI_BYTE, rows.data(), sizeof(RankCosts), MPI_BYTE, 0, communicator);
  if (rank != 0) rows.clear();
  return rows;
}

}  // namespace toccata
