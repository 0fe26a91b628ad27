#include "narrow/convex_sweeps.hpp"

// How two convex shapes lie, with containment, compared with rational arithmetic.
namespace toccata::test {
namespace {

Relation ask(const PosedConvex& a, const PosedConvex& b, ConvexWorkspace* workspace) {
  return relation(a, b, workspace);
}

/// What the oracle calls it; the enumerators have one order.
Relation truth_of(const oracle::Relation& truth, bool a_solid, bool b_solid) {
  return {.kind = static_cast<RelationKind>(truth.kind),
          .containment = static_cast<Containment>(truth.containment),
          .side_unresolved = truth.side_unresolved,
          .a_solid = a_solid,
          .b_solid = b_solid,
          .status = Status::exact};
}

std::string to_text(const Relation& r) {
  return "kind " + std::to_string(static_cast<int>(r.kind)) + " containment " +
         std::to_string(static_cast<int>(r.containment));
}

std::string check(const SeenCase& seen) {
  const bool a_solid = is_solid(seen.given.a), b_solid = is_solid(seen.given.b);
  const oracle::Relation slow = oracle::relation(seen.set_a, a_solid, seen.set_b, b_solid);
  const Relation truth = truth_of(slow, a_solid, b_solid);
  const Relation answer = relation(seen.a, seen.b);
  if (!(answer == truth)) return to_text(answer) + " and not " + to_text(truth);
  if (!(relation(seen.b, seen.a) == truth_of(flipped(slow), b_solid, a_solid))) return "exchanged";
  return compare_warm(seen, ask);
}

SweepResult run(const std::string& kind, std::uint64_t seed, std::uint64_t cases) {
  return run_convex_cases(kind, seed, cases, check);
}

const bool known = register_sweep({"convex-relation", convex_kinds(), convex_goal, convex_slice, run, convex_shard});

}  // namespace
}  // namespace toccata::test
