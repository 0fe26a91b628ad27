// Generalised winding numbers of posed soups: every triangle in 50 digits.
#include "query/winding_checks.hpp"
#include "support/sweep.hpp"

namespace toccata::test {
namespace {

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random seeds(seed);
  for (; result.cases < cases; ++result.cases) {
    const std::uint64_t case_seed = seeds.bits();
    Random random(case_seed);
    const PointCase c = point_case(family, random);
    const double tolerance = std::pow(10, random.between(-11, -0.5));
    const WindingNumber found = generalized_winding_number(c.point, Model(c.mesh), c.pose, {.tolerance = tolerance});
    const std::string fault = winding_fault(exact_winding(c), found, tolerance);
    if (!fault.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("{}, case seed {}: {}", family, case_seed, fault);
  }
  return result;
}

const bool known = register_sweep({"winding-numbers", point_families(), 100'000, 30, run, 2000, 5});

}  // namespace
}  // namespace toccata::test
