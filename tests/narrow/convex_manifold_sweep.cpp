#include <algorithm>
#include <cmath>

#include "narrow/penetration_checks.hpp"
#include "support/sweep.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Manifolds, and overlap by separating axes, of every kind of shape with every other, in every regime.
namespace toccata::test {
namespace {

bool is_feature_of(const ConvexFeature& feature, const PosedPolytope& shape) {
  const HullTopology topology = shape.topology();
  if (feature.kind == ConvexFeature::Kind::vertex) return feature.index < shape.vertex_count();
  if (feature.kind == ConvexFeature::Kind::edge) return feature.index < topology.origin.size();
  return feature.index < topology.face_count();
}

/// Every point lies between the shapes: on both, but for rounding, when they are grown by half its depth.
bool lies_between(const ManifoldPoint& p, const oracle::ConvexSet& a, const oracle::ConvexSet& b, double size) {
  const oracle::ConvexSet point = oracle::point_set(p.position);
  const oracle::Rational near = oracle::exact(0.5 * std::fabs(p.depth) + 0x1p-45 * size);
  return oracle::compare_distance(point, a, near) <= 0 && oracle::compare_distance(point, b, near) <= 0;
}

std::string check_convex_manifold(const ConvexCase& pair) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const oracle::ConvexSet set_a = set_of(pair.a), set_b = set_of(pair.b);
  const bool meet = oracle::overlap(set_a, set_b);
  if (overlap_by_separating_axes(a, b) != meet) return "overlap by separating axes";
  const Manifold m = manifold(a, b);
  if ((m.count > 0) != meet) return "count";
  if (!same_shapes(set_a, set_b) && !same_but_flipped(m, manifold(b, a))) return "exchanged";
  SimplexCache workspace;
  for (int times = 0; times < 2; ++times)
    if (!(manifold(a, b, &workspace) == m)) return "with a workspace";
  if (!meet) return "";
  if (m.count > 4 || !is_nearly_unit(m.normal)) return "normal";
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    const ManifoldPoint& p = m.points[i];
    if (!is_finite(p.position) || !std::isfinite(p.depth)) return "not finite";
    if (!is_feature_of(p.on_a, a) || !is_feature_of(p.on_b, b)) return "features";
    if (!lies_between(p, set_a, set_b, size_of(set_a) + size_of(set_b))) return "position";
  }
  return "";
}

SweepResult run_convex_manifold(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  // Seeds in a row would give streams that are shifted by a draw each.
  Random random(Random(seed).bits());
  for (; result.cases < cases; ++result.cases) {
    const ConvexCase pair = numbered_case(family, result.cases, random);
    const std::string wrong = check_convex_manifold(pair);
    if (wrong.empty()) continue;
    if (result.wrong++ == 0)
      result.first_failure = wrong + ", case " + std::to_string(result.cases) + ": " + to_text(pair);
  }
  return result;
}

const bool convex_manifold_known =
    register_sweep({"convex-manifold", convex_kinds(), 100'000, 1050, run_convex_manifold, 2000, 250});

}  // namespace
}  // namespace toccata::test
