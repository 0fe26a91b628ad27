#pragma once

#include <cstddef>

#include "crowd_run.hpp"

namespace toccata {

/// How many questions for the k nearest boxes a rank answers in a second.
struct NearestRates {
  double alone = 0;            ///< one rank that has all boxes, and asks those of rank 0
  double of_a_rank = 0;        ///< each rank asks about places among its boxes, all at once; the slowest of them
  double without_waiting = 0;  ///< the same, without the time that it waits for messages and other ranks
};

/// Collective. Rank 0 sees that it is answered the same both ways, bit for bit, and throws Error where not; on the
/// others there is nothing to tell.
[[nodiscard]] NearestRates nearest_rates(const CrowdOfRanks& crowd, std::size_t questions, std::size_t k);

}  // namespace toccata
