#pragma once

#include <vector>

#include "measure.hpp"
#include "sweeps.hpp"

namespace toccata::bench {

/// What one library answered of a set, and what was wrong with it.
struct AnsweredSweeps {
  Result result;
  std::vector<SweepAnswer> answers{};
  std::size_t missed = 0;        ///< told free, and at some time the bodies overlap
  std::size_t false_alarms = 0;  ///< told met, and they are nowhere as near as `sweep_tolerance`
  std::size_t late = 0;          ///< told met more than `sweep_tolerance` of the time after they do
  std::size_t early = 0;         ///< told met at a time at which they are a hundredth of a body apart
  std::size_t undecided = 0;     ///< told that they may meet
};

inline constexpr double sweep_tolerance = 0.01;

/// The first is Toccata. Both bodies are posed at 401 times (meshes at 51), and around those that any library tells,
/// and asked whether they overlap, exactly: where they do at a time before they are told to meet, the answer is missed
/// or late. For Toccata's own, any such time makes it wrong; so does a hit at which the bodies are more than rounding
/// apart.
void judge(const SweepWork& work, std::vector<AnsweredSweeps>& answered);

}  // namespace toccata::bench
