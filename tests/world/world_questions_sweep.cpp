#include "support/sweep.hpp"
#include "world/world_queries_checks.hpp"

// Questions to Worlds that live, compared with asking every body by itself.
namespace toccata::test {
namespace {

SweepResult run_world_questions(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random seeds(Random(seed).bits());
  SweepResult result;
  while (result.cases < cases) {
    const std::uint64_t case_seed = seeds.bits();
    Random random(case_seed);
    const bool convex = random.below(2) == 0;
    QuestionedWorld world(family, convex);
    for (int frame = 0; frame < 20 && result.cases < cases; ++frame) {
      world.live(random);
      const std::string fault = world.fault(random);
      ++result.cases;
      if (!fault.empty() && result.wrong++ == 0)
        result.first_failure =
            fmt::format("seed {}, {}, frame {}: {}", case_seed, convex ? "convex" : "any", frame, fault);
    }
  }
  return result;
}

const bool world_questions_known =
    register_sweep({"world-questions", crowd_families(), 100'000, 20, run_world_questions, 2000});

}  // namespace
}  // namespace toccata::test
