#include "narrow/closed_forms.hpp"
#include "support/convex_cases.hpp"
#include "support/sweep.hpp"
#include "toccata/narrow/capsule.hpp"

// The closed formulas are right or silent, and what is built on them is right, for pairs of simple shapes in every
// regime, as the oracle answers.
namespace toccata::test {
namespace {

const std::vector<std::string> kinds = {"point", "segment", "triangle", "sphere", "box", "capsule"};

std::string fault_of(const ConvexCase& pair) {
  const PosedConvex a = posed(pair.a), b = posed(pair.b);
  const bool meet = oracle::overlap(set_of(pair.a), set_of(pair.b));
  const Nearness found = nearness_by_formula(a, b);
  if (found != Nearness::unknown && (found == Nearness::meet) != meet) return "the formula is wrong";
  if (overlap(a, b) != meet || overlap(b, a) != meet) return "overlap is wrong";
  const auto* sphere = std::get_if<Sphere>(&pair.a.shape);
  const auto* box = std::get_if<Box>(&pair.b.shape);
  if (sphere == nullptr || box == nullptr) return "";
  return overlap(PosedSphere(*sphere, pair.a.pose), PosedBox(*box, pair.b.pose)) == meet ? ""
                                                                                         : "sphere and box are wrong";
}

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(seed * 0x9e3779b97f4a7c15ULL + 11);
  for (; result.cases < cases; ++result.cases) {
    const std::string& kind_a = kinds[result.cases % kinds.size()];
    const std::string& kind_b = kinds[result.cases / kinds.size() % kinds.size()];
    const ConvexCase pair = convex_case(kind_a, kind_b, family, random);
    const std::string fault = fault_of(pair);
    if (fault.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = fault + ", case " + std::to_string(result.cases) + ": " + to_text(pair);
  }
  return result;
}

const bool known = register_sweep({"closed-forms", convex_regimes(), 100'000, 200, run});

}  // namespace
}  // namespace toccata::test
