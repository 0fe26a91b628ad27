#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "toccata/core/parallel.hpp"

namespace toccata {

/// Boxes that move, in a DistributedWorld over all ranks.
struct CrowdOfRanks {
  std::size_t count = 100'000;  ///< of all ranks together
  std::size_t frames = 10;
  std::string scene = "uniform";
  std::uint64_t seed = 1;
  int threads = own_thread;
};

/// Of one rank: sums over the frames but for the bodies, ghosts and pairs, which are those of the last.
struct RankCosts {
  double milliseconds = 0;  ///< the median of a step
  double bodies = 0, ghosts = 0, pairs = 0, candidates = 0, came = 0, bytes = 0, imbalance = 0, divisions = 0;
};

/// By rank, on rank 0; else nothing.
[[nodiscard]] std::vector<RankCosts> costs_of_ranks(const CrowdOfRanks& crowd);

}  // namespace toccata
