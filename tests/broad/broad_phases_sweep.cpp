#include <string>

#include <fmt/format.h>

#include "broad/box_families.hpp"
#include "broad/box_life.hpp"
#include "broad/mixed_life.hpp"
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

/// The same of balls, oriented boxes, and both beside boxes.
std::string wrong_in_a_mixed_life(const std::string& method, std::uint64_t seed) {
  Random random(seed);
  MixedLife bodies({broad_phase_method(method), seed % 2 == 0 ? 1 : 2}, 1 + seed % 3);
  for (int frame = 0; frame < 60; ++frame)
    if (const std::string wrong = bodies.live(frame, random); !wrong.empty())
      return fmt::format("{} with seed {} in frame {}: {}", method, seed, frame, wrong);
  return {};
}

template <std::string (*wrong_in)(const std::string&, std::uint64_t)>
SweepResult run_broad_phases(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  for (; result.cases < cases; ++result.cases) {
    const std::string wrong = wrong_in(family, 1'000'003 * seed + result.cases);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0) result.first_failure = wrong;
  }
  return result;
}

std::vector<std::string> families() { return {box_families.begin(), box_families.end()}; }

const bool broad_phases_known =
    register_sweep({"broad-phases", families(), 100, 1, run_broad_phases<wrong_in_a_life>, 10, 1}) &&
    register_sweep(
        {"broad-phases-of-bounds", broad_phase_names(), 100, 1, run_broad_phases<wrong_in_a_mixed_life>, 10, 1});

}  // namespace
}  // namespace toccata::test
