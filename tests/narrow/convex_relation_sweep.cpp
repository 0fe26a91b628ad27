#include "narrow/convex_sweeps.hpp"

// The relation of two convex shapes, with containment, compared with rational arithmetic.
namespace toccata::test {
namespace {

Relation ask_convex_relation(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  return relation(a, b, workspace);
}

/// As the library must tell it.
Relation truth_of(const oracle::Relation& truth, bool a_solid, bool b_solid) {
  return {static_cast<RelationKind>(truth.kind),
          static_cast<Containment>(truth.containment),
          truth.side_unresolved,
          a_solid,
          b_solid,
          Status::exact};
}

std::string in_words(const Relation& r) {
  return "kind " + std::to_string(static_cast<int>(r.kind)) + ", containment " +
         std::to_string(static_cast<int>(r.containment)) + (r.side_unresolved ? ", side unresolved" : "");
}

std::string check_convex_relation(const SeenCase& seen) {
  const bool a_solid = is_solid(seen.given.a), b_solid = is_solid(seen.given.b);
  const oracle::Relation truth = oracle::relation(seen.set_a, a_solid, seen.set_b, b_solid);
  const Relation expected = truth_of(truth, a_solid, b_solid);
  const Relation answer = relation(seen.a, seen.b);
  if (!(answer == expected)) return in_words(answer) + " instead of " + in_words(expected);
  if (!(relation(seen.b, seen.a) == truth_of(oracle::flipped(truth), b_solid, a_solid))) return "exchanged";
  return compare_warm(seen, ask_convex_relation);
}

SweepResult run_convex_relation(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_convex_cases(cell, seed, cases, check_convex_relation);
}

const bool convex_relation_known = register_sweep({"convex-relation", cells_of(convex_kinds()), cell_goal, cell_slice,
                                                   run_convex_relation, cell_shard, 2 * cell_round});

}  // namespace
}  // namespace toccata::test
