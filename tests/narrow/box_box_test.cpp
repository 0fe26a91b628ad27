#include "toccata/narrow/box_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "narrow/boxes/rigid_box_axes.hpp"
#include "support/convex_cases.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

Pose at(double x, double y, double z) { return Pose::translation(x, y, z); }

struct Answer {
  bool overlap;
  Relation relation;
  Penetration penetration;
  Manifold manifold;
  ConvexCounts counts;
  friend bool operator==(const Answer&, const Answer&) = default;
};

std::vector<Answer> answers_in_all_regimes() {
  std::vector<Answer> answers;
  Random random(11);
  for (const std::string& regime : test::convex_regimes())
    for (int i = 0; i < 20; ++i) {
      const test::ConvexCase pair = test::convex_case("box", "box", regime, random);
      const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
      SimplexCache workspace;
      answers.push_back({overlap(a, b, &workspace), relation(a, b), {}, manifold(a, b), workspace.counts});
      answers.back().penetration = penetration(a, b, &workspace);
    }
  return answers;
}

TEST(BoxBox, AnswersAndCountsAreTheSameAtEverySimdLevel) {
  const std::vector<Answer> expected = answers_in_all_regimes();
  test::at_every_simd_level([&](SimdLevel) { EXPECT_TRUE(answers_in_all_regimes() == expected); });
}

TEST(BoxBox, TouchingBoxesOverlapAndAreNotDeep) {
  const PosedBox below(Box({1, 1, 1})), above(Box({0.5, 0.5, 0.5}), at(0.25, 0.25, 1.5));
  EXPECT_TRUE(overlap(below, above));
  EXPECT_EQ(penetration(below, above).upper, 0);
  EXPECT_EQ(manifold(below, above).count, 4);
  const PosedBox higher(Box({0.5, 0.5, 0.5}), at(0.25, 0.25, 1.5000000000000002));
  EXPECT_FALSE(overlap(below, higher));
  EXPECT_EQ(manifold(below, higher).count, 0);
}

TEST(BoxBox, NeedsTheEdgePairs) {
  const PosedBox below(Box({2, 0.5, 0.5}), {rotation_about({1, 0, 0}, 45), {}});
  const Mat3 turned = rotation_about({0, 1, 0}, 45);
  EXPECT_FALSE(overlap(below, PosedBox(Box({0.5, 2, 0.5}), {turned, {0, 0, 1.42}})));
  const PosedBox above(Box({0.5, 2, 0.5}), {turned, {0, 0, 1.41}});
  EXPECT_TRUE(overlap(below, above));
  EXPECT_NEAR(penetration(below, above).upper, 2 * 0.70710678118654752 - 1.41, 1e-12);
  EXPECT_EQ(manifold(below, above).points[0].on_a.kind, ConvexFeature::Kind::edge);
}

TEST(BoxBox, TakesBoxesAndPosesWherePosedBoxesAreTaken) {
  const Mat3 turned = rotation_about({1, 2, 3}, 40);
  const Box box({1, 1, 0.5}, {10, 0, 0});
  const Vec3 beside = turned.column(0);
  EXPECT_TRUE(overlap(box, {turned, {}}, box, {turned, 1.9375 * beside}));
  EXPECT_FALSE(overlap(box, {turned, {}}, box, {turned, 2.0625 * beside}));
  EXPECT_TRUE(overlap(Box({1, 1, 1}), {}, Box({1, 1, 1}), at(0, 0, 2)));
  EXPECT_FALSE(overlap(Box({1, 1, 1}), {}, Box({1, 1, 1}), at(0, 0, 2.0000000000000004)));
  Pose stretched;
  stretched.linear[0].x = 3;
  EXPECT_TRUE(overlap(Box({1, 1, 1}), stretched, Box({1, 1, 1}), at(3.75, 0, 0)));
  EXPECT_FALSE(overlap(Box({1, 1, 1}), stretched, Box({1, 1, 1}), at(4.25, 0, 0)));
  Pose flat;
  flat.linear[2].z = 0;
  EXPECT_THROW(static_cast<void>(overlap(box, flat, box, {})), Error);
  EXPECT_THROW(static_cast<void>(overlap(box, {}, box, at(0, 0, HUGE_VAL))), Error);
  EXPECT_THROW(static_cast<void>(overlap(box, {}, box, at(0, NAN, 0))), Error);
  EXPECT_THROW(static_cast<void>(penetration(box, flat, box, {})), Error);
  EXPECT_THROW(static_cast<void>(manifold(box, {}, box, at(0, NAN, 0))), Error);
  EXPECT_EQ(manifold(Box({1, 1, 1}), {}, Box({1, 1, 1}), at(0, 0, 2)).count, 4);
}

// Stacked alike and turned: all edges are parallel, so that three edge pairs have no axis.
TEST(BoxBox, OfBoxesTurnedAlikeIsDecidedByTheFormula) {
  const Mat3 turned = rotation_about({1, 2, 3}, 40);
  const PosedPolytope below(Box({1, 1, 0.5}), {turned, {}});
  const PosedPolytope above(Box({0.5, 0.5, 0.5}), {turned, 0.875 * turned.column(2)});
  SimplexCache workspace;
  EXPECT_TRUE(overlap(below, above, &workspace));
  EXPECT_EQ(relation(below, above, &workspace).kind, RelationKind::overlapping);
  EXPECT_EQ(workspace.counts.exact, 0U);
  EXPECT_EQ(manifold(below, above).count, 4);
  // Boxes that nobody has posed too, so that no corner is made.
  const auto told = [&](const Pose& first, const Pose& second) {
    return nearness_of_boxes(Box({1, 1, 0.5}), first, Box({0.5, 0.5, 0.5}), second);
  };
  EXPECT_EQ(told({turned, {}}, {turned, 0.875 * turned.column(2)}), Nearness::meet);
  EXPECT_EQ(told({turned, {}}, {turned, 1.125 * turned.column(2)}), Nearness::apart);
  EXPECT_EQ(told({}, at(0, 1.25, 0.875)), Nearness::meet);
  EXPECT_EQ(told({}, at(0, 1.625, 0.875)), Nearness::apart);
  EXPECT_EQ(told({}, at(0, 1.5, 0)), Nearness::unknown);  // they touch, which exact numbers find
}

TEST(BoxBox, PenetrationAlongTheAxesOfTheWorldIsTheLeastDifferenceOfCoordinates) {
  const double hair = 0x1p-50;
  const PosedPolytope below(Box({1, 2, 3})), above(Box({1, 2, 3}), at(0.5, -1, 6 - hair));
  SimplexCache workspace;
  const Penetration p = penetration(below, above, &workspace);
  EXPECT_EQ(p.lower, hair);
  EXPECT_EQ(p.upper, hair);
  EXPECT_EQ(p.direction, (Vec3{0, 0, 1}));
  EXPECT_EQ(p.on_a - p.on_b, (Vec3{0, 0, hair}));
  EXPECT_EQ(penetration(above, below).direction, (Vec3{0, 0, -1}));
  EXPECT_EQ(workspace.counts.closed_forms, 1U);
}

// A turn by a right angle keeps a box along the axes.
TEST(BoxBox, PenetrationOfBoxesTurnedByRightAnglesIsADifferenceOfCoordinatesToo) {
  const Mat3 turned = {{{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}}}};
  const PosedPolytope below(Box({3, 1, 2}), {turned, {}}), above(Box({1, 2, 2}), at(0, 0, 5 - 0x1p-50));
  SimplexCache workspace;
  EXPECT_EQ(penetration(below, above, &workspace).upper, 0x1p-50);
  EXPECT_EQ(workspace.counts.closed_forms, 1U);
}

// Squares of these sizes over- or underflow.
TEST(BoxBox, ManifoldsOfHugeAndTinyBoxesHaveTheirPoints) {
  for (const double size : {5e-324, 1e-300, 1e-154, 1e154, 1e160, 8e307}) {
    const PosedPolytope below(Box({size, size, size}));
    const Manifold on_box = manifold(below, PosedPolytope(Box({size, size, size}), at(0, 0, size)));
    EXPECT_EQ(on_box.count, 4) << size;
    EXPECT_DOUBLE_EQ(on_box.points[0].depth, size);
    const PosedHalfSpace floor(HalfSpace({0, 0, 0}, {0, 0, 1}));
    const Manifold on_floor = manifold(below, floor);
    EXPECT_EQ(on_floor.count, 4) << size;
    for (const ManifoldPoint& p : on_floor.points) EXPECT_DOUBLE_EQ(p.depth, size);
  }
}

}  // namespace
}  // namespace toccata
