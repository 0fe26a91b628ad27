#pragma once

#include <vector>

#include "movers.hpp"

namespace toccata::bench {

/// What is wrong with the steps of a library's characters, judged by Toccata's exact questions, which are the same for
/// all and made otherwise than its mover.
struct WalkFaults {
  std::size_t steps = 0;     ///< judged
  double walked = 0;         ///< lengths of their level parts, summed
  std::size_t catches = 0;   ///< in a straight corridor: steps that make less than nine tenths of the wish along it
  double lost = 0;           ///< there: the share of all wishes along it that was not made
  std::size_t overlaps = 0;  ///< steps that end with the capsule in something
  double deepest = 0;        ///< how deep its axis is in the shell of that radius at most; the radius where it is met
  std::size_t tunnels = 0;   ///< walks that ended because the capsule's middle had passed through something
};

/// Feet of a walk: of its start, and after each step.
using WalkedFeet = std::vector<Vec3>;

/// As many steps of each walk as count: up to the first that passes through something or leaves the level.
std::vector<std::size_t> counted_steps(const WalkWork& work, const SceneIndex& level,
                                       const std::vector<WalkedFeet>& walked);

WalkFaults judged_walks(const WalkWork& work, const SceneIndex& level, const std::vector<WalkedFeet>& walked);

}  // namespace toccata::bench
