#pragma once

#include <cstddef>

#include "crowd_run.hpp"

namespace toccata {

/// What a machine and its network take, measured or assumed.
struct MachineCosts {
  double seconds_a_body = 0;  ///< of a step of one World that has it
  double latency = 0;         ///< of a message between two ranks, in seconds
  double bandwidth = 0;       ///< in bytes a second
};

/// What a rank has to do in a step.
struct RankLoad {
  double bodies = 0;
  double ghosts = 0;       ///< as a share of them
  double imbalance = 1;    ///< of the busiest over the average
  double bytes = 0;        ///< that it sends
  double collectives = 0;  ///< reductions and barriers
};

/// How long a step on so many ranks takes, each with a core of its own: what one World takes for the bodies and ghosts
/// of the busiest rank, what the bytes take, and a message for each doubling of the ranks in each collective.
[[nodiscard]] double predicted_seconds(const MachineCosts& machine, const RankLoad& load, double ranks);

/// How much surface a part of space shares with others, on average, in faces of a cube as large as the part: where a
/// cube is halved along its longest sides until there are so many parts (a power of two).
[[nodiscard]] double inner_faces(double ranks);

/// The load where uniform boxes are divided, from that of 2 ranks: ghosts grow with what surface a
/// part shares with others, and its bodies with its volume.
[[nodiscard]] RankLoad load_from_two(const RankLoad& of_two, double bodies, double ranks);

[[nodiscard]] RankLoad average_load(const std::vector<RankCosts>& rows, double frames);

/// Collective: messages of 8 bytes and of a megabyte go to and fro between ranks 0 and 1. Of one rank alone nothing is
/// measured, and all is 0.
[[nodiscard]] MachineCosts measured_network();

}  // namespace toccata
