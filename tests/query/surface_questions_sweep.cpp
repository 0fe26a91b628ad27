#include "query/surface_questions_checks.hpp"
#include "support/sweep.hpp"

// The nearest elements, signed distances, elements within regions, and tolerances, of height fields and compounds under
// every kind of pose, against rational arithmetic.
namespace toccata::test {
namespace {

SweepResult run_surface_questions(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  Random seeds(Random(seed).bits());
  SweepResult result;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const std::uint64_t case_seed = seeds.bits();
    Random random(case_seed);
    const std::string& place = surface_places()[i % surface_places().size()];
    const SurfaceCase c = surface_case(family, place, random);
    const Vec3 point = point_of(c, random);
    const std::string fault = surface_fault(c, point, random);
    ++result.cases;
    if (!fault.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("case {}, seed {}, {}, point {:a} {:a} {:a}: {}", i, case_seed, place, point.x,
                                         point.y, point.z, fault);
  }
  return result;
}

const bool surface_questions_known =
    register_sweep({"surface-questions", surface_families(), 100'000, 100, run_surface_questions, 1000});

}  // namespace
}  // namespace toccata::test
