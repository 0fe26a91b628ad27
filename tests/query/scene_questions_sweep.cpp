#include "query/scene_index_checks.hpp"
#include "support/sweep.hpp"

// Questions about crowds of every kind of shape, compared with asking every object by itself.
namespace toccata::test {
namespace {

SweepResult run_scene_questions(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random seeds(Random(seed).bits());
  SweepResult result;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const std::uint64_t case_seed = seeds.bits();
    Random random(case_seed);
    const bool convex = i % 2 == 0;
    const QuestionedCrowd crowd(family, 1 + random.below(40), convex, random);
    const std::string fault = crowd_fault(crowd, convex, random);
    ++result.cases;
    if (!fault.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("case {}, seed {}, {}: {}", i, case_seed, convex ? "convex" : "any", fault);
  }
  return result;
}

const bool scene_questions_known =
    register_sweep({"scene-questions", crowd_families(), 100'000, 20, run_scene_questions, 2000});

}  // namespace
}  // namespace toccata::test
