#include "crowd_run.hpp"

#include <mpi.h>

#include <algorithm>
#include <chrono>

#include "toccata/distributed.hpp"
#include "toccata/generate/crowds.hpp"

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

RankCosts costs_of_this(const CrowdOfRanks& wanted) {
  DistributedOptions options;
  options.world.threads = wanted.threads;
  DistributedWorld world({MPI_Comm_c2f(MPI_COMM_WORLD)}, options);
  Crowd crowd(wanted.scene, wanted.count, wanted.seed);
  world.add(bodies_to_give(crowd, world));
  world.step();
  RankCosts row;
  std::vector<double> milliseconds;
  for (std::size_t frame = 0; frame < wanted.frames; ++frame) {
    move_those_here(crowd, world);
    const auto begin = std::chrono::steady_clock::now();
    const DistributedCosts& costs = world.step().costs;
    milliseconds.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    row.bodies = static_cast<double>(costs.bodies);
    row.ghosts = static_cast<double>(costs.ghosts);
    row.candidates = static_cast<double>(costs.candidates);
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

}  // namespace

std::vector<RankCosts> costs_of_ranks(const CrowdOfRanks& crowd) {
  const RankCosts own = costs_of_this(crowd);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<RankCosts> rows(static_cast<std::size_t>(ranks));
  MPI_Gather(&own, sizeof(RankCosts), MPI_BYTE, rows.data(), sizeof(RankCosts), MPI_BYTE, 0, MPI_COMM_WORLD);
  if (rank != 0) rows.clear();
  return rows;
}

}  // namespace toccata
