#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "broad/box_life.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

/// Frames of one life by one method, a case each. What it keeps must not become more than it was at most in the first
/// fifth, but for the chance of a more crowded frame.
SweepResult run_broad_memory(const std::string& method, std::uint64_t seed, std::uint64_t frames) {
  Random random(seed);
  BoxLife boxes("sizes", {broad_phase_method(method), 1});
  SweepResult result;
  result.first_failure = boxes.add(120, random);
  if (!result.first_failure.empty()) result.wrong = 1;
  std::size_t most_early = 0, most_numbers = 0;
  for (; result.cases < frames; ++result.cases) {
    boxes.live_on(static_cast<int>(result.cases), random);
    if (result.cases < std::max<std::uint64_t>(frames / 5, 60)) {
      most_early = std::max(most_early, boxes.bytes());
      most_numbers = std::max(most_numbers, boxes.numbers());
    } else if ((boxes.bytes() > most_early + most_early / 2 || boxes.numbers() > most_numbers + most_numbers / 2) &&
               result.wrong++ == 0) {
      result.first_failure =
          fmt::format("{} with seed {}: {} bytes for {} numbers in frame {}, at most {} for {} before", method, seed,
                      boxes.bytes(), boxes.numbers(), result.cases, most_early, most_numbers);
    }
  }
  return result;
}

const bool broad_memory_known =
    register_sweep({"broad-phase-memory", broad_phase_names(), 100'000, 300, run_broad_memory, 100'000, 100});

}  // namespace
}  // namespace toccata::test
