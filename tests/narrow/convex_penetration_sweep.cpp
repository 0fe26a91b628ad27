#include "narrow/convex_cells.hpp"
#include "narrow/penetration_checks.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Penetration of every kind of solid with every other, in every regime, compared with rational arithmetic and with
// itself under exchange.
namespace toccata::test {
namespace {

const std::vector<std::string> solid_kinds{"sphere",      "box",           "capsule",         "hull",
                                           "needle-hull", "rounded-point", "rounded-segment", "rounded-triangle",
                                           "rounded-box", "rounded-hull"};

bool same_seen_from_b(const Penetration& p, const Penetration& q) {
  return p.lower == q.lower && p.upper == q.upper && p.direction == -q.direction && p.on_a == q.on_b &&
         p.on_b == q.on_a;
}

std::string check_convex_penetration(const ConvexCase& pair, Random&) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  if (!a.solid() || !b.solid()) return "";
  const oracle::ConvexSet set_a = set_of(pair.a), set_b = set_of(pair.b);
  if (!oracle::is_solid(set_a) || !oracle::is_solid(set_b)) return "";
  const double size = size_of(set_a) + size_of(set_b);
  const oracle::Depth depth(set_a, set_b);
  const Penetration by_expansion = penetration_by_expansion(a, b);
  const std::string wrong = wrong_with(by_expansion, set_a, set_b, depth, size);
  if (!wrong.empty()) return "by expansion: " + wrong;
  if (!same_shapes(set_a, set_b) && !same_seen_from_b(by_expansion, penetration_by_expansion(b, a)))
    return "by expansion: exchanged";
  const Penetration by_axes = penetration_by_separating_axes(a, b);
  const std::string wrong_by_axes = wrong_with(by_axes, set_a, set_b, depth, size);
  if (!wrong_by_axes.empty()) return "by separating axes: " + wrong_by_axes;
  if (!same_shapes(set_a, set_b) && !same_seen_from_b(by_axes, penetration_by_separating_axes(b, a)))
    return "by separating axes: exchanged";
  return "";
}

SweepResult run_convex_penetration(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_cell(cell, seed, cases, check_convex_penetration);
}

const bool convex_penetration_known = register_sweep({"convex-penetration", cells_of(solid_kinds), cell_goal,
                                                      4 * cell_round, run_convex_penetration, cell_shard, cell_round});

}  // namespace
}  // namespace toccata::test
