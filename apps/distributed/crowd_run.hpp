#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/distributed.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {

/// Boxes that move, in a DistributedWorld over all ranks.
struct CrowdOfRanks {
  std::size_t count = 100'000;  ///< of all ranks together
  std::size_t frames = 10;
  std::string scene = "uniform";
  std::uint64_t seed = 1;
  int threads = own_thread;
  double moving = 1;                  ///< which share of the boxes goes where the scene moves them; the others stay
  std::optional<int> communicator{};  ///< as MPI_Comm_c2f tells it; that of all ranks, if nothing is said
};

/// What one rank had: sums over the frames but for the bodies, ghosts and pairs, which are those of the last.
struct RankCosts {
  double milliseconds = 0;  ///< the median of a step
  double bodies = 0, ghosts = 0, pairs = 0, candidates = 0, came = 0, bytes = 0, imbalance = 0, divisions = 0;
  double bytes_bound = 0;          ///< `bound_of_bytes`
  double most_bytes_of_bound = 0;  ///< of a frame, as a share
  double collectives = 0;
  DistributedSeconds seconds{};
  double processor_seconds = 0;  ///< in steps, waiting included: it asks again and again whether there is something
  double peak_bytes = 0;         ///< of memory, since the program began
};

/// 100 bytes for each ghost of the bodies of here, and 4 KiB for each rank that has some.
[[nodiscard]] double bound_of_bytes(const DistributedCosts& costs);

/// All of a step, and what of it is there since bodies are on several ranks: to see how even the work is, to send and
/// to take up.
[[nodiscard]] double total(const DistributedSeconds& seconds);
[[nodiscard]] double migration(const DistributedSeconds& seconds);

/// With the boxes of this rank, whichever part of space they are in, and one step made.
[[nodiscard]] DistributedWorld world_of_crowd(const Crowd& crowd, const CrowdOfRanks& wanted);

/// By rank, on rank 0; else nothing.
[[nodiscard]] std::vector<RankCosts> costs_of_ranks(const CrowdOfRanks& crowd);

}  // namespace toccata
