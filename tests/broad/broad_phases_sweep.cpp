#include <string>

#include <fmt/format.h>

#include "broad/box_families.hpp"
#include "broad/box_life.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

/// Sixty frames by every method, on one thread or two.
std::string wrong_in_a_life(const std::string& family, std::uint64_t seed) {
  for (const BroadPhaseMethod method : broad_phase_methods()) {
    Random random(seed);
    BoxLife boxes(family, {method, seed % 2 == 0 ? 1 : 2});
    std::string wrong = boxes.add(80, random);
    for (int frame = 0; frame < 60 && wrong.empty(); ++frame) wrong = boxes.live(frame, random);
    if (!wrong.empty()) return fmt::format("{} of {} with seed {}: {}", name_of(method), family, seed, wrong);
  }
  return {};
}

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  for (; result.cases < cases; ++result.cases) {
    const std::string wrong = wrong_in_a_life(family, 1'000'003 * seed + result.cases);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0) result.first_failure = wrong;
  }
  return result;
}

std::vector<std::string> families() { return {box_families.begin(), box_families.end()}; }

const bool known = register_sweep({"broad-phases", families(), 100, 1, run, 10, 1});

}  // namespace
}  // namespace toccata::test
