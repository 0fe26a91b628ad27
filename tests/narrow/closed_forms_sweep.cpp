#include "narrow/primitives/closed_forms.hpp"

#include "narrow/convex_cells.hpp"
#include "narrow/convex_distance_checks.hpp"
#include "narrow/primitives/pair_distances.hpp"
#include "narrow/typed_forms.hpp"

// The closed formulas of overlap and distance are right or silent, and what is built on them is right, for pairs of
// simple shapes in every regime, as the oracle answers.
namespace toccata::test {
namespace {

const std::vector<std::string> kinds = {"point", "segment", "triangle", "sphere", "box", "capsule"};

std::string fault_of_closed_forms(const ConvexCase& pair, Random&) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const bool meet = oracle::overlap(set_of(pair.a), set_of(pair.b));
  const Nearness found = nearness_by_formula(a, b);
  if (found != Nearness::unknown && (found == Nearness::meet) != meet) return "the formula is wrong";
  if (overlap(a, b) != meet || overlap(b, a) != meet) return "overlap is wrong";
  const std::optional<TypedAnswers> typed = typed_answers(pair);
  if (typed && typed->overlap != meet) return "the pair's own overlap is wrong";
  const std::optional<TypedAnswers> given = answers_of_given(pair);
  if (given && given->overlap != meet) return "overlap of shapes and poses is wrong";
  const bool by_formula = is_known(distance_of_primitives(a, b));
  if (typed && !same_answer(typed->distance, distance(a, b), by_formula))
    return "the pair's own distance has other bits";
  if (given && !same_answer(given->distance, distance(a, b), by_formula))
    return "the distance of shapes and poses has other bits";
  // What no formula tells is the business of another sweep.
  return by_formula ? distance_fault(pair) : "";
}

SweepResult run_closed_forms(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_cell(cell, seed, cases, fault_of_closed_forms);
}

const bool closed_forms_known = register_sweep(
    {"closed-forms", cells_of(kinds), cell_goal, cell_slice, run_closed_forms, 10 * cell_shard, 5 * cell_round});

}  // namespace
}  // namespace toccata::test
