// Bodies that move and turn against the oracle, with what must not change the answer.
#include "support/rigid_cases.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

SweepResult run_rigid(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  for (const RigidFamily& f : rigid_families()) {
    if (f.name != family) continue;
    Random random(seed);
    for (; result.cases < cases; ++result.cases) {
      const RigidCase pair = f.draw(random);
      const std::optional<ShapeHit> answer = swept(pair);
      auto wrong = wrong_sweep(pair, answer);
      if (!wrong) wrong = changed_sweep(pair, answer);
      if (wrong && result.wrong++ == 0)
        result.first_failure = "seed " + std::to_string(seed) + " case " + std::to_string(result.cases) + ": " + *wrong;
    }
  }
  return result;
}

std::vector<std::string> rigid_family_names() {
  std::vector<std::string> names;
  for (const RigidFamily& family : rigid_families()) names.push_back(family.name);
  return names;
}

const bool rigid_known = register_sweep({.name = "rigid-sweeps",
                                         .families = rigid_family_names(),
                                         .goal = 100'000,
                                         .slice = 10,
                                         .run = run_rigid,
                                         .shard = 1000,
                                         .thin_slice = 2});

}  // namespace
}  // namespace toccata::test
