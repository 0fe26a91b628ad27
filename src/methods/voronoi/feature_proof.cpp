#include "methods/voronoi/feature_proof.hpp"

#include "methods/voronoi/others_clear.hpp"
#include "narrow/exact/nearest_formula.hpp"

namespace toccata {
namespace {

/// Edges that spread a feature of A start at its first vertex, those of B end there.
template <ConvexFeature::Kind kind_a, ConvexFeature::Kind kind_b>
[[gnu::always_inline]] inline SpreadFeatures spread_features(const WalkBody& a, const WalkBody& b,
                                                             const FeaturesAsked& asked) {
  const auto &of_a = asked.corners[0].vertex, &of_b = asked.corners[1].vertex;
  constexpr auto edges_of_a = static_cast<std::size_t>(kind_a), edges_of_b = static_cast<std::size_t>(kind_b);
  SpreadFeatures spread{a.vertex(of_a[0]), b.vertex(of_b[0]), {}, edges_of_a, edges_of_b};
  if constexpr (edges_of_a > 0) spread.edge[0] = a.vertex(of_a[1]) - spread.on_a;
  if constexpr (edges_of_a > 1) spread.edge[1] = a.vertex(of_a[2]) - spread.on_a;
  if constexpr (edges_of_b > 0) spread.edge[edges_of_a] = spread.on_b - b.vertex(of_b[1]);
  if constexpr (edges_of_b > 1) spread.edge[1] = spread.on_b - b.vertex(of_b[2]);
  return spread;
}

/// A look at all vertices, which is seldom needed.
[[gnu::noinline]] bool others_beyond(const PosedPolytope& a, const PosedPolytope& b, const FeaturesAsked& asked) {
  const SupportKernels kernels = support_kernels();
  const SupportSearch search_a(a, kernels), search_b(b, kernels);
  const NearestFeatures features = features_of(asked);
  const FeaturePoints points = points_of(features, search_a, search_b);
  NearestFormula formula(features, points);
  return formula.prove(search_a, search_b);
}

/// One function for each two kinds: its numbers are many and stay where they are.
template <ConvexFeature::Kind kind_a, ConvexFeature::Kind kind_b>
std::optional<Distance> proved(const PosedPolytope& a, const WalkBody& body_a, const PosedPolytope& b,
                               const WalkBody& body_b, const FeaturesAsked& asked) {
  FormulaNumbers numbers;
  if (!solve_formula(spread_features<kind_a, kind_b>(body_a, body_b, asked), numbers)) return {};
  const double spread = height_spread(numbers.across, numbers.slack);
  const Others of_a = other_vertices<kind_a>(body_a, asked.feature[0].index, numbers.across, spread);
  if (of_a == Others::lower) return {};
  const Others of_b = other_vertices<kind_b>(body_b, asked.feature[1].index, -numbers.across, spread);
  if (of_b == Others::lower) return {};
  if (!(of_a == Others::clear && of_b == Others::clear) && !others_beyond(a, b, asked)) return {};
  if (a.radius() + b.radius() == 0) return plain_formula_distance(numbers.nearest);
  // Number by number: a copy as a whole would keep all of them in memory.
  const FormulaNearest& n = numbers.nearest;
  return offset_formula_distance(
      {n.on_a, n.on_b, n.point_error, n.difference, n.difference_error, n.distance, n.distance_error}, a.radius(),
      b.radius());
}

}  // namespace

std::optional<Distance> proved_distance(const PosedPolytope& a, const WalkBody& body_a, const PosedPolytope& b,
                                        const WalkBody& body_b, const FeaturesAsked& asked) {
  const ConvexFeature::Kind kind_a = asked.feature[0].kind, kind_b = asked.feature[1].kind;
  if (kind_a == ConvexFeature::Kind::face)
    return proved<ConvexFeature::Kind::face, ConvexFeature::Kind::vertex>(a, body_a, b, body_b, asked);
  if (kind_b == ConvexFeature::Kind::face)
    return proved<ConvexFeature::Kind::vertex, ConvexFeature::Kind::face>(a, body_a, b, body_b, asked);
  if (kind_a == ConvexFeature::Kind::edge)
    return kind_b == ConvexFeature::Kind::edge
               ? proved<ConvexFeature::Kind::edge, ConvexFeature::Kind::edge>(a, body_a, b, body_b, asked)
               : proved<ConvexFeature::Kind::edge, ConvexFeature::Kind::vertex>(a, body_a, b, body_b, asked);
  return kind_b == ConvexFeature::Kind::edge
             ? proved<ConvexFeature::Kind::vertex, ConvexFeature::Kind::edge>(a, body_a, b, body_b, asked)
             : proved<ConvexFeature::Kind::vertex, ConvexFeature::Kind::vertex>(a, body_a, b, body_b, asked);
}

}  // namespace toccata
