#include <fmt/format.h>

#include "support/mover_levels.hpp"
#include "support/sweep.hpp"

// Random walks of characters in levels of many kinds, each step judged by distances to everything in the level.
namespace toccata::test {
namespace {

SweepResult run_character_walks(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random seeds(Random(seed).bits());
  SweepResult result;
  while (result.cases < cases) {
    const std::uint64_t case_seed = seeds.bits();
    Random random(case_seed);
    const MoverLevelCase level = random_level(family, random);
    for (int walk = 0; walk < 10 && result.cases < cases; ++walk) {
      const std::string fault = fault_of_walk(level, random, 40);
      ++result.cases;
      if (!fault.empty() && result.wrong++ == 0)
        result.first_failure = fmt::format("seed {}, walk {}, {}", case_seed, walk, fault);
    }
  }
  return result;
}

const bool character_walks_known = register_sweep({.name = "character-walks",
                                                   .families = {level_families.begin(), level_families.end()},
                                                   .goal = 100'000,
                                                   .slice = 4,
                                                   .run = run_character_walks,
                                                   .shard = 500,
                                                   .thin_slice = 1});

}  // namespace
}  // namespace toccata::test
