// How an overlap stands to a tolerance, what kind of clash it is and the point that is told of it, of solids that are
// as deep in each other as closed forms, a linear program or cells of a grid tell; both ways round.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "oracle/meshes.hpp"
#include "query/tolerance_cases.hpp"
#include "support/case_seeds.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::test {
namespace {

using Tolerance = PairAnswer::Tolerance;
using ClashKind = PairAnswer::Kind;
using Piercing = PairAnswer::Piercing;

/// Beside the depth by less and less, at it, and anywhere.
double some_tolerance(double depth, Random& random) {
  const double beside = std::exp2(-static_cast<double>(random.below(30)));
  switch (random.below(6)) {
    case 0:
      return depth;
    case 1:
      return depth * (1 - beside);
    case 2:
      return depth * (1 + beside);
    case 3:
      return depth * random.between(0, 2);
    case 4:
      return random.below(2) == 0 ? 0 : 1e3 * depth;
    default:
      return depth * std::exp2(random.between(-8, 4));
  }
}

PairAnswer answer_about(const Model& a, const Model& b, const PairQuery& query, const CheckOptions& options) {
  const std::vector<SceneInstance> both{{.model = a, .pose = query.pose_a}, {.model = b, .pose = query.pose_b}};
  const CheckAnswer found = check_all(both, options);
  return found.pairs.empty() ? PairAnswer{} : found.pairs[0];
}

/// Whichever depth decided it tells what it was decided to be.
Tolerance by_bracket(double lower, double upper, double tolerance) {
  return upper <= tolerance ? Tolerance::within : lower > tolerance ? Tolerance::beyond : Tolerance::undecided;
}

std::string fault_of_depth_told(const ToleranceCase& made, const PairAnswer& found, double tolerance) {
  const oracle::LocalDepth& truth = made.depth;
  if (found.local_depth) {
    const auto& [lower, upper] = *found.local_depth;
    if (lower > truth.upper) return fmt::format("{} deep or more, where it is {}", lower, truth.upper);
    if (upper < truth.lower) return fmt::format("{} deep at most, where it is {}", upper, truth.lower);
    return by_bracket(lower, upper, tolerance) == found.tolerance ? "" : "the local depth did not decide it";
  }
  if (!found.penetration) return "two solids have no depth";
  const auto& [lower, upper] = std::pair(found.penetration->lower, found.penetration->upper);
  if (upper < truth.lower) return fmt::format("parted by {}, and {} deep", upper, truth.lower);
  if (by_bracket(lower, upper, tolerance) != found.tolerance) return "the penetration did not decide it";
  // Nearer than that the search may end before it has found out.
  const double unclear = 1e-3 * truth.upper + 1e-9 * made.size;
  const bool is_clear = tolerance < truth.lower - unclear || tolerance > truth.upper + unclear;
  const bool is_by_places = made.is_clean && found.relation.containment == Containment::none;
  // What parts them is looked at first where it is known.
  return is_by_places && is_clear && found.tolerance != Tolerance::within ? "no local depth decided it" : "";
}

std::string fault_of_verdict(const ToleranceCase& made, const PairAnswer& found, double tolerance) {
  if (found.relation.kind != RelationKind::overlapping)
    return found.tolerance == Tolerance::none && !found.local_depth ? "" : "a tolerance of what does not overlap";
  if (found.tolerance == Tolerance::none) return "no verdict";
  if (found.tolerance == Tolerance::within && made.depth.lower > tolerance)
    return fmt::format("within {}, and {} deep", tolerance, made.depth.lower);
  return fault_of_depth_told(made, found, tolerance);
}

std::string fault_of_clash_kind(const ToleranceCase& made, const PairAnswer& found) {
  if (made.relation && found.relation.kind != made.relation->kind) return "another relation";
  if (made.relation && found.relation.containment != made.relation->containment) return "another containment";
  if (found.relation.kind != RelationKind::overlapping) return "";
  if (found.relation.containment != Containment::none) {
    const bool are_equal = found.relation.containment == Containment::equal;
    return found.kind == (are_equal ? ClashKind::equal : ClashKind::contains) ? ""
                                                                              : "the kind is not of the containment";
  }
  const bool is_told = found.kind == ClashKind::protrude || found.kind == ClashKind::pierce;
  if (!is_told && found.kind != ClashKind::overlap) return "the kind is not of an overlap";
  if (!made.clash) return "";
  if (made.clash->has_curves && !is_told) return "it is not told whether one passes through the other";
  if (made.clash->pierces && found.kind != ClashKind::pierce) return "it pierces";
  // Curves whose triangles have corners in common are taken for those of one place.
  if (!made.clash->pierces && made.clash->has_curves_apart && found.kind == ClashKind::pierce)
    return "it does not pierce";
  // It may be left open, as where the triangles of two curves have a corner in common.
  if (made.clash->piercing && found.piercing != Piercing::unknown && found.piercing != *made.clash->piercing)
    return "another one pierces";
  return "";
}

/// It lies in both, exactly, and off their surfaces.
std::string fault_of_point(const ToleranceCase& made, const PairAnswer& found) {
  if (found.relation.kind != RelationKind::overlapping) return found.common_point ? "a point of what only touches" : "";
  if (!found.common_point) return made.depth.lower > 1e-6 * made.size ? "no point" : "";
  const oracle::RationalPoint point = oracle::exact(*found.common_point);
  for (const auto& [mesh, pose] : {std::pair(&made.a, &made.query.pose_a), std::pair(&made.b, &made.query.pose_b)}) {
    const oracle::Location at = oracle::locate(point, oracle::solid_set(*mesh, *pose));
    if (at.on_face || at.winding_number == 0) return at.on_face ? "the point is on a face" : "the point is outside";
  }
  return "";
}

Piercing flipped_piercing(Piercing piercing) {
  if (piercing == Piercing::a_through_b) return Piercing::b_through_a;
  return piercing == Piercing::b_through_a ? Piercing::a_through_b : piercing;
}

/// Where depth and tolerance differ by rounding alone, one order may leave open what the other decides.
std::string fault_of_other_order(const PairAnswer& one, const PairAnswer& other, bool differs_by_rounding) {
  if (one.relation.kind != other.relation.kind) return "exchanged, another relation";
  if (!differs_by_rounding && one.tolerance != other.tolerance) return "exchanged, another verdict";
  if (!differs_by_rounding && one.local_depth != other.local_depth) return "exchanged, another local depth";
  if (one.kind != other.kind) return "exchanged, another kind";
  if (one.piercing != flipped_piercing(other.piercing)) return "exchanged, another one pierces";
  if (one.volume != other.volume) return "exchanged, another volume";
  return "";
}

std::string fault_of_tolerance(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const ToleranceCase made = random_tolerance_case(family, random);
  const double tolerance = some_tolerance(std::max(0.0, made.depth.lower), random);
  // Volumes of what meets itself take long, and so do narrow brackets of what parts solids: they have their own sweeps.
  const bool volume = random.below(made.is_clean ? 2 : 16) == 0;
  const CheckOptions options{
      .penetration = random.below(8) == 0, .depth = {.precision = 1}, .volume = volume, .tolerance = tolerance};
  const Model a(made.a), b(made.b);
  const PairAnswer found = answer_about(a, b, made.query, options),
                   other = answer_about(b, a, {made.query.pose_b, made.query.pose_a}, options);
  const double rounding = 1e-9 * made.size;
  const bool differs_by_rounding = tolerance > made.depth.lower - rounding && tolerance < made.depth.upper + rounding;
  std::string fault = fault_of_verdict(made, found, tolerance);
  if (fault.empty()) fault = fault_of_verdict(made, other, tolerance);
  if (fault.empty() && options.volume) fault = fault_of_clash_kind(made, found);
  if (fault.empty() && options.volume) fault = fault_of_point(made, found);
  if (fault.empty()) fault = fault_of_other_order(found, other, differs_by_rounding);
  if (fault.empty()) return "";
  return fmt::format("{} (depth [{}, {}], tolerance {})", fault, made.depth.lower, made.depth.upper, tolerance);
}

SweepResult run_tolerances(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) { return fault_of_tolerance(family, case_seed); });
}

const bool tolerances_known =
    register_sweep({"tolerances", tolerance_families(), 10'000, 100, run_tolerances, 1000, 10});

}  // namespace
}  // namespace toccata::test
