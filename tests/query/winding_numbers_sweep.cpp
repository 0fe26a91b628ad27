// Generalised winding numbers of posed soups: every triangle in 50 digits.
#include "query/winding_checks.hpp"
#include "support/case_seeds.hpp"

namespace toccata::test {
namespace {

SweepResult run_winding_numbers(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) {
    Random random(case_seed);
    const PointCase c = point_case(family, random);
    const double tolerance = std::pow(10, random.between(-11, -0.5));
    const WindingNumber found = generalized_winding_number(c.point, Model(c.mesh), c.pose, {.tolerance = tolerance});
    return winding_fault(exact_winding(c), found, tolerance);
  });
}

const bool winding_numbers_known =
    register_sweep({"winding-numbers", point_families(), 100'000, 30, run_winding_numbers, 2000, 5});

}  // namespace
}  // namespace toccata::test
