#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "narrow/exact/exact_distance.hpp"
#include "narrow/exact/nearest_formula.hpp"
#include "support/convex_cases.hpp"

// That distances are right and the same by every way is swept (convex_distance_sweep.cpp). Here: what the formula alone
// promises.
namespace toccata {
namespace {

VertexPairs pairs(std::initializer_list<std::pair<Index, Index>> list) {
  VertexPairs result;
  for (const auto& [a, b] : list) result.append(a, b);
  return result;
}

NearestFeatures reversed(const NearestFeatures& f) { return {f.b, f.a, f.count_b, f.count_a}; }

/// Calls `visit` with the searches and the features at which a search ended, of pairs of many kinds and regimes.
template <class Visit>
void for_many_pairs(const Visit& visit) {
  const SupportKernels kernels = support_kernels();
  std::uint64_t number = 0;
  for (const char* kind : {"point", "segment", "triangle", "box", "hull", "needle-hull"})
    for (std::uint64_t i = 0; i < 210; ++i) {
      Random random(++number);
      const test::ConvexCase pair = test::numbered_case(kind, i, random);
      const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
      const SupportSearch search_a(a, kernels), search_b(b, kernels);
      const GjkEnd end = search_nearest(search_a, search_b, {}, {std::numeric_limits<double>::quiet_NaN()});
      if (const auto features = canonical_features(end.simplex.pairs)) visit(search_a, search_b, *features, pair);
    }
}

double largest_coordinate(const PosedPolytope& shape) {
  double largest = 0;
  for (Index i = 0; i < shape.vertex_count(); ++i)
    for (int axis = 0; axis < 3; ++axis) largest = std::fmax(largest, std::fabs(shape.vertex(i)[axis]));
  return largest;
}

TEST(NearestFormula, IsOffByNoMoreThanItSays) {
  int proved = 0;
  for_many_pairs([&](const SupportSearch& a, const SupportSearch& b, const NearestFeatures& features,
                     const test::ConvexCase& pair) {
    const FeaturePoints points = points_of(features, a, b);
    NearestFormula formula(features, points);
    if (!formula.prove(a, b)) return;
    ++proved;
    const FormulaNearest& nearest = formula.nearest();
    const Distance exact = rounded_distance(exact_nearest(a.shape(), b.shape(), pairs({{0, 0}})), 0, 0);
    EXPECT_LE(nearest.distance - nearest.distance_error, exact.upper) << to_text(pair);
    EXPECT_GE(nearest.distance + nearest.distance_error, exact.lower) << to_text(pair);
    const double size = std::fmax(largest_coordinate(a.shape()), largest_coordinate(b.shape()));
    const double off = nearest.point_error + 0x1p-48 * size;
    EXPECT_LE(length(nearest.on_a - exact.on_a), off) << to_text(pair);
    EXPECT_LE(length(nearest.on_b - exact.on_b), off) << to_text(pair);
    EXPECT_LE(length(nearest.difference - (exact.on_a - exact.on_b)), nearest.difference_error + 0x1p-48 * size)
        << to_text(pair);
  });
  EXPECT_GT(proved, 300);
}

TEST(NearestFormula, TurnsRoundWithTheShapesBitByBit) {
  for_many_pairs([&](const SupportSearch& a, const SupportSearch& b, const NearestFeatures& features,
                     const test::ConvexCase& pair) {
    const NearestFeatures other_way = reversed(features);
    const FeaturePoints points = points_of(features, a, b), other_points = points_of(other_way, b, a);
    NearestFormula forth(features, points), back(other_way, other_points);
    const bool proved = forth.prove(a, b);
    ASSERT_EQ(proved, back.prove(b, a)) << to_text(pair);
    if (!proved) return;
    EXPECT_EQ(forth.nearest().on_a, back.nearest().on_b) << to_text(pair);
    EXPECT_EQ(forth.nearest().on_b, back.nearest().on_a) << to_text(pair);
    EXPECT_EQ(forth.nearest().difference, -back.nearest().difference) << to_text(pair);
    EXPECT_EQ(forth.nearest().distance, back.nearest().distance) << to_text(pair);
    EXPECT_EQ(forth.nearest().distance_error, back.nearest().distance_error) << to_text(pair);
    const double radius_a = a.shape().radius(), radius_b = b.shape().radius();
    const auto answer = forth.distance(radius_a, radius_b), answer_back = back.distance(radius_b, radius_a);
    ASSERT_EQ(answer.has_value(), answer_back.has_value()) << to_text(pair);
    if (answer) {
      EXPECT_EQ(answer->lower, answer_back->lower);
    }
  });
}

TEST(NearestFormula, KnowsFeaturesInWhateverOrderTheyWereFound) {
  const NearestFeatures face{{2, 5, 9}, {4, 0, 0}, 3, 1}, edges{{3, 7, 0}, {1, 8, 0}, 2, 2};
  EXPECT_EQ(canonical_features(pairs({{9, 4}, {2, 4}, {5, 4}})), face);
  EXPECT_EQ(canonical_features(pairs({{5, 4}, {9, 4}, {2, 4}})), face);
  EXPECT_EQ(canonical_features(pairs({{7, 1}, {3, 8}, {3, 1}})), edges);
  EXPECT_EQ(canonical_features(pairs({{3, 1}, {7, 8}})), edges);  // the diagonal
  EXPECT_FALSE(canonical_features(pairs({{1, 2}, {3, 4}, {5, 6}})));
  EXPECT_FALSE(canonical_features(pairs({{1, 2}, {3, 2}, {5, 2}, {7, 2}})));
}

TEST(NearestFormula, TakesAVertexInForAnother) {
  const NearestFeatures face{{2, 5, 9}, {4, 0, 0}, 3, 1};
  EXPECT_EQ(exchanged(face, 2, {true, 3}), (NearestFeatures{{2, 3, 5}, {4, 0, 0}, 3, 1}));
  EXPECT_EQ(exchanged(face, 1, {false, 1}), (NearestFeatures{{2, 9, 0}, {1, 4, 0}, 2, 2}));
  EXPECT_EQ(exchanged(face, 3, {false, 1}), (NearestFeatures{{2, 5, 9}, {1, 0, 0}, 3, 1}));
  EXPECT_FALSE(exchanged(face, 3, {true, 1}));  // nothing of B would be left
}

TEST(NearestFormula, RefusesFacesThatAreEquallyNearEverywhere) {
  const SupportKernels kernels = support_kernels();
  const PosedPolytope a(Box({1, 1, 1})), b(Box({1, 1, 1}), Pose::translation(0.5, 0.25, 3));
  const SupportSearch search_a(a, kernels), search_b(b, kernels);
  const GjkEnd end = search_nearest(search_a, search_b, {}, {std::numeric_limits<double>::quiet_NaN()});
  if (const auto features = canonical_features(end.simplex.pairs)) {
    const FeaturePoints points = points_of(*features, search_a, search_b);
    EXPECT_FALSE(NearestFormula(*features, points).prove(search_a, search_b));
  }
}

TEST(NearestFormula, ProvesNearlyAllHullsThatAreApart) {
  const SupportKernels kernels = support_kernels();
  int asked = 0, proved = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    Random random(i);
    const test::ConvexCase pair = test::convex_case("hull", "hull", "near", random);
    const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
    const SupportSearch search_a(a, kernels), search_b(b, kernels);
    const GjkEnd end = search_nearest(search_a, search_b, {}, {std::numeric_limits<double>::quiet_NaN()});
    const auto features = canonical_features(end.simplex.pairs);
    if (end.inside || !features) continue;
    ++asked;
    const FeaturePoints points = points_of(*features, search_a, search_b);
    NearestFormula formula(*features, points);
    proved += formula.prove(search_a, search_b) && formula.distance(0, 0) ? 1 : 0;
  }
  EXPECT_GT(asked, 250);
  EXPECT_GE(proved, asked * 95 / 100);
}

}  // namespace
}  // namespace toccata
