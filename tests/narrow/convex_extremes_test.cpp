#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "oracle/convex.hpp"
#include "support/simd_levels.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/box_box.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Sizes at which products of lengths leave the doubles.
namespace toccata {
namespace {

TEST(ConvexExtremes, CoordinatesOfAllSizesInOneShapeEnd) {
  const std::vector<Vec3> of_a = {{0, -1.1683373810743968e+105, -1.3831649286878621e+235},
                                  {3.4570885737324933e+236, 2.0616218943811045e-78, -8364496499652147},
                                  {-3.1789653978341053e-99, -4.5505704253171553e+197, -2.0735163118744963e+186},
                                  {0, -1.4041572665799743e+66, -1.7827326032378889e+43},
                                  {-2.0439595354249792e+281, 2.1980758118711169e-98, 6.561275530064286e+74}};
  const std::vector<Vec3> of_b = {{0, 2.7747068315984756e+124, -1.1247147010269589e+139},
                                  {-1.1596586363467475e+175, 9.5444155841762875e-36, 0}};
  const ConvexHull a(of_a), b(of_b);
  const bool meet = oracle::overlap(oracle::hull_set(of_a), oracle::hull_set(of_b));
  EXPECT_EQ(overlap(PosedPolytope(a), PosedPolytope(b)), meet);
  EXPECT_EQ(distance(PosedPolytope(b), PosedPolytope(a)).upper == 0, meet);
}

TEST(ConvexExtremes, BoxesOfAnySizeMeetOrNotAlikeInEveryWay) {
  for (const double size : {1e-300, 1e-150, 1e-80, 1.0, 1e77, 1e102, 3e102, 1e150, 1e200, 1e300})
    for (int turn = 0; turn < 40; ++turn) {
      const PosedPolytope a(Box({size, 2 * size, 0.5 * size}), {rotation_about({1, 2, 3}, 9.0 * turn), {}});
      const PosedPolytope b(Box({size, size, size}),
                            {rotation_about({3, -1, 1}, 7.0 * turn), {size * (1 + 0.05 * turn), size, 0.1 * size}});
      const bool meet = relation(a, b).kind != RelationKind::apart;
      const Manifold found = manifold(a, b);
      EXPECT_EQ(overlap(a, b), meet) << size << " " << turn;
      EXPECT_EQ(overlap_by_separating_axes(a, b), meet) << size << " " << turn;
      EXPECT_EQ(found.count > 0, meet) << size << " " << turn;
      if (!meet) continue;
      EXPECT_NEAR(dot(found.normal, found.normal), 1, 1e-9) << size << " " << turn;
      for (int i = 0; i < found.count; ++i) {
        const ManifoldPoint& point = found.points[static_cast<std::size_t>(i)];
        EXPECT_TRUE(is_finite(point.position) && std::isfinite(point.depth)) << size << " " << turn;
      }
    }
}

TEST(ConvexExtremes, ABallInABoxOfAnySize) {
  for (const double size : {1e-300, 1e-100, 1.0, 1e76, 1e80, 1e100, 1e140, 1e300})
    EXPECT_EQ(relation(PosedPolytope(Sphere(size)), PosedPolytope(Box({3 * size, 3 * size, 3 * size}))).containment,
              Containment::a_in_b)
        << size;
}

TEST(ConvexExtremes, AManifoldHasTheDeepestPoint) {
  const PosedPolytope capsule(Capsule({0, 0, -1}, {0, 0, 1}, 0.5)), box(Rounded(Box({1, 1, 1}), 0.25));
  const PosedPolytope slanted(Rounded(Box({1, 1, 1}), 0.25), {rotation_about({1, 1, 0}, 50), {0.4, 0.1, 1.2}});
  for (const auto& [a, b] : {std::pair(&capsule, &box), std::pair(&box, &slanted), std::pair(&capsule, &slanted)}) {
    const Manifold found = manifold(*a, *b);
    double deepest = 0;
    for (int i = 0; i < found.count; ++i) deepest = std::fmax(deepest, found.points[static_cast<std::size_t>(i)].depth);
    EXPECT_NEAR(deepest, penetration(*a, *b).upper, 1e-6);
  }
}

ConvexHull scaled_hull(std::vector<Vec3> points, double size) {
  for (Vec3& point : points) point = size * point;
  return ConvexHull(points);
}

TEST(ConvexExtremes, TheCommonPointOfHugeHullsIsTheSameAtEveryLevel) {
  for (const double size : {1e150, 1e155, 1e200, 1e290}) {
    const ConvexHull a = scaled_hull({{0, -1, 3}, {2, 3, -2}, {1, 3, 0}, {-3, -3, -3}, {-1, 3, 0}}, size);
    const ConvexHull b = scaled_hull({{1, 1, -1}, {-2, 2, 3}, {0, 1, 0}, {3, -1, -2}, {-2, -3, -2}}, size);
    Pose turned, beside;
    turned.linear = beside.linear = rotation_about(Vec3{1, 2, 3}, 40);
    beside.offset = {0.5 * size, 0, 0};
    std::vector<Distance> answers;
    test::at_every_simd_level(
        [&](SimdLevel) { answers.push_back(distance(PosedPolytope(a, turned), PosedPolytope(b, beside))); });
    EXPECT_EQ(answers.front().upper, 0);
    for (const Distance& answer : answers) EXPECT_EQ(answer, answers.front()) << size;
  }
}

/// A box of height 1e-17, which vanishes beside the 1 of its place.
PosedPolytope sheet_that_rounding_made() { return PosedPolytope(Box({1, 1, 1e-17}), Pose::translation(0, 0, 1)); }

TEST(ConvexExtremes, ASolidThatRoundingHasFlattenedHasNoDepth) {
  const PosedPolytope sheet = sheet_that_rounding_made();
  const Box big({2, 2, 3});
  const ConvexHull cut(std::vector<Vec3>{{-2, -2, -3}, {2, -2, -3}, {-2, 2, -3}, {0, 0, 4}});
  for (const PosedPolytope& other :
       {PosedPolytope(big), PosedPolytope(cut), PosedPolytope(Sphere(1, {0, 0, 1})), sheet}) {
    ASSERT_EQ(relation(sheet, other).kind, RelationKind::touching);
    for (const Penetration& p :
         {penetration(sheet, other), penetration(other, sheet), penetration_by_expansion(sheet, other)}) {
      EXPECT_EQ(p.lower, 0);
      EXPECT_EQ(p.upper, 0);
      EXPECT_EQ(p.on_a, p.on_b);
    }
  }
  EXPECT_EQ(penetration(PosedBox(Box({1, 1, 1e-17}), Pose::translation(0, 0, 1)), PosedBox(big)).upper, 0);
}

TEST(ConvexExtremes, ASolidThatRoundingHasFlattenedOnlyTouchesAHalfSpace) {
  const PosedHalfSpace below(HalfSpace({0, 0, 3}, {0, 0, 1}));
  EXPECT_EQ(relation(sheet_that_rounding_made(), below).kind, RelationKind::touching);
  EXPECT_EQ(penetration(sheet_that_rounding_made(), below).upper, 0);
}

}  // namespace
}  // namespace toccata
