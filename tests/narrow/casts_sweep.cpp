#include "narrow/casts_checks.hpp"
#include "support/sweep.hpp"

// Every kind of convex shape cast against every kind, from every regime, as the oracle answers.
namespace toccata::test {
namespace {

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(seed * 0x9e3779b97f4a7c15ULL + 13);
  const std::vector<std::string>& kinds = convex_kinds();
  for (; result.cases < cases; ++result.cases) {
    const std::string& kind_a = kinds[result.cases % kinds.size()];
    const std::string& kind_b = kinds[result.cases / kinds.size() % kinds.size()];
    const ConvexCase pair = convex_case(kind_a, kind_b, family, random);
    const Vec3 motion = random_motion(pair, random);
    const Cast cast = cast_shape(posed(pair.a), motion, posed(pair.b));
    const std::string fault = cast_fault(cast, set_of(pair.a), motion, set_of(pair.b));
    if (fault.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = fault + ", case " + std::to_string(result.cases) + ": " + to_text(pair);
  }
  return result;
}

const bool known = register_sweep({"casts", convex_regimes(), 20'000, 100, run, 2'000});

}  // namespace
}  // namespace toccata::test
