#include "scale_model.hpp"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace toccata {
namespace {

/// Half of the time to and fro.
double seconds_of_message(std::size_t bytes, int times, int rank) {
  std::vector<char> message(bytes);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < times; ++i)
    for (const int from : {0, 1}) {
      if (rank == from)
        MPI_Send(message.data(), static_cast<int>(bytes), MPI_CHAR, 1 - from, 0, MPI_COMM_WORLD);
      else
        MPI_Recv(message.data(), static_cast<int>(bytes), MPI_CHAR, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
  const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
  return all.count() / (2 * times);
}

}  // namespace

double predicted_seconds(const MachineCosts& machine, const RankLoad& load, double ranks) {
  const double work = (1 + load.ghosts) * load.imbalance * load.bodies * machine.seconds_a_body;
  if (ranks <= 1) return work;
  return work + load.bytes / machine.bandwidth + load.collectives * machine.latency * std::ceil(std::log2(ranks));
}

double inner_faces(double ranks) {
  std::array<double, 3> parts{1, 1, 1};  // along each axis
  for (double halves = 1; halves < ranks; halves *= 2) *std::min_element(parts.begin(), parts.end()) *= 2;
  // Between n parts along an axis are n - 1 borders, which both sides have; a part is a 1/n of the cube's side thick.
  double faces = 0;
  for (const double along : parts) faces += 2 * (along - 1);
  return faces / std::cbrt(parts[0] * parts[1] * parts[2]);
}

RankLoad load_from_two(const RankLoad& of_two, double bodies, double ranks) {
  RankLoad load = of_two;
  load.bodies = bodies;
  const double of_a_face = of_two.ghosts * std::cbrt(of_two.bodies) / inner_faces(2);
  load.ghosts = of_a_face * inner_faces(ranks) / std::cbrt(bodies);
  const double bytes_of_a_ghost = of_two.bytes / std::max(of_two.ghosts * of_two.bodies, 1.);
  load.bytes = bytes_of_a_ghost * load.ghosts * bodies;
  return load;
}

RankLoad average_load(const std::vector<RankCosts>& rows, double frames) {
  RankLoad load;
  double ghosts = 0;
  const auto ranks = static_cast<double>(rows.size());
  for (const RankCosts& row : rows) {
    load.bodies += row.bodies / ranks;
    ghosts += row.ghosts / ranks;
    load.bytes += row.bytes / frames / ranks;
    load.collectives += row.collectives / frames / ranks;
    load.imbalance = row.imbalance;
  }
  load.ghosts = ghosts / std::max(load.bodies, 1.);
  return load;
}

MachineCosts measured_network() {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::array<double, 2> costs{};
  constexpr std::size_t megabyte = 1'000'000;
  if (ranks > 1 && rank < 2) {
    static_cast<void>(seconds_of_message(megabyte, 3, rank));
    costs = {seconds_of_message(8, 500, rank), seconds_of_message(megabyte, 20, rank)};
  }
  MPI_Bcast(costs.data(), 2, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return {0, costs[0], ranks > 1 ? static_cast<double>(megabyte) / costs[1] : 0};
}

}  // namespace toccata
