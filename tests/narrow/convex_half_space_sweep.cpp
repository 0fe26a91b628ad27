#include "narrow/convex_half_space_checks.hpp"
#include "support/sweep.hpp"

// Every kind of convex shape against a half-space, in every regime, as the oracle answers.
namespace toccata::test {
namespace {

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(seed * 0x9e3779b97f4a7c15ULL + 7);
  const std::vector<std::string>& kinds = convex_kinds();
  for (; result.cases < cases; ++result.cases) {
    const HalfSpaceCase pair = half_space_case(kinds[result.cases % kinds.size()], family, random);
    const std::string fault = half_space_fault(pair);
    if (fault.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = fault + ", case " + std::to_string(result.cases) + ": " + to_text(pair);
  }
  return result;
}

const bool known = register_sweep({"convex-half-space", convex_regimes(), 100'000, 300, run});

}  // namespace
}  // namespace toccata::test
