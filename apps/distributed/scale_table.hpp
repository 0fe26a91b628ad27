#pragma once

#include <string>

#include "crowd_run.hpp"

namespace toccata {

/// The network between many machines, which is assumed.
struct NetworkOfMany {
  double microseconds = 2;
  double gigabytes = 10;  ///< a second
};

/// Collective: the crowd of a scene on 1, 2, 4, … of the ranks, as measured, and beside it what the model foretells of
/// what was counted there, and from what one and two ranks took alone; then for 64 and 1,024 ranks.
void print_scale(const std::string& scene, CrowdOfRanks crowd, const NetworkOfMany& network);

}  // namespace toccata
