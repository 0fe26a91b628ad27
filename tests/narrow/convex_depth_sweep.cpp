#include "narrow/convex_sweeps.hpp"
#include "oracle/penetration.hpp"
#include "toccata/core/error.hpp"

// The penetration of two convex solids: the bracket holds the exact depth, and a move by it parts them.
namespace toccata::test {
namespace {

using oracle::Rational;
using oracle::RationalPoint;

Penetration ask_convex_depth(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace) {
  return penetration(a, b, workspace);
}

bool is_refused(const SeenCase& seen) {
  try {
    static_cast<void>(penetration(seen.a, seen.b));
    return false;
  } catch (const Error&) {
    return true;
  }
}

std::string check_bracket(const Penetration& p, const SeenCase& seen) {
  if (!(p.lower >= 0) || !(p.lower <= p.upper) || !std::isfinite(p.upper)) return "no bracket";
  if (!oracle::is_solid(seen.set_a) || !oracle::is_solid(seen.set_b))
    return p.upper == 0 ? "" : "what rounding has flattened has a depth";
  const oracle::Depth depth(seen.set_a, seen.set_b);
  if (depth.compare(oracle::exact(p.lower)) < 0) return "lower is too large";
  if (depth.compare(oracle::exact(p.upper)) > 0) return "upper is too small";
  return is_narrow(p) ? "" : "the bracket is wide";
}

/// The translation of the length `upper` along the direction, exactly.
std::string check_move(const Penetration& p, const SeenCase& seen) {
  if (!is_finite(p.direction)) return "the direction is no direction";
  if (p.upper == 0) return "";
  if (!is_unit(p.direction)) return "the direction is not of length 1";
  const RationalPoint move = oracle::exact(p.upper) * oracle::exact(p.direction);
  return oracle::interiors_meet(seen.set_a, oracle::moved(seen.set_b, move)) ? "they overlap after the move" : "";
}

std::string check_points(const Penetration& p, const SeenCase& seen) {
  if (p.upper == 0) return is_finite(p.on_a) && is_finite(p.on_b) ? "" : "points are no points";
  const double rounding = 0x1p-33 * largest_coordinate(seen);
  if (!is_within(p.on_a, seen.set_a, rounding)) return "on_a is not on A";
  if (!is_within(p.on_b, seen.set_b, rounding)) return "on_b is not on B";
  const Vec3 rest = p.on_a - p.on_b - p.upper * p.direction;
  return std::hypot(rest.x, rest.y, rest.z) <= 2 * rounding ? "" : "the points do not lie along the direction";
}

std::string check_convex_depth(const SeenCase& seen) {
  if (!is_solid(seen.given.a) || !is_solid(seen.given.b)) return is_refused(seen) ? "" : "a surface is not refused";
  const Penetration p = penetration(seen.a, seen.b);
  if (p.status != Status::exact) return "status";
  for (const auto& part : {check_bracket, check_move, check_points}) {
    std::string wrong = part(p, seen);
    if (!wrong.empty()) return wrong;
  }
  const Penetration exchanged = penetration(seen.b, seen.a);
  if (exchanged.lower != p.lower || exchanged.upper != p.upper) return "exchanged";
  const Penetration back{p.lower, p.upper, -exchanged.direction, exchanged.on_b, exchanged.on_a};
  if (!check_move(back, seen).empty() || !check_points(back, seen).empty()) return "move exchanged";
  return compare_warm(seen, ask_convex_depth);
}

SweepResult run_convex_depth(const std::string& cell, std::uint64_t seed, std::uint64_t cases) {
  return run_convex_cases(cell, seed, cases, check_convex_depth);
}

const bool convex_depth_known = register_sweep({"convex-depth", cells_of(convex_kinds()), cell_goal, 20 * cell_round,
                                                run_convex_depth, cell_shard, 2 * cell_round});

}  // namespace
}  // namespace toccata::test
