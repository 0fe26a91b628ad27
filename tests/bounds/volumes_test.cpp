// What the sweep does not show: that volumes are tight, and what they do with nothing and with bad input.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/mesh_soups.hpp"
#include "support/volume_cases.hpp"
#include "support/volume_sets.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/methods/cost.hpp"

namespace toccata {
namespace {

template <class V>
class EveryVolume : public testing::Test {};
TYPED_TEST_SUITE(EveryVolume, AllVolumes::put_into<testing::Types>);

/// Points of a turned box with edges 2 · size around the centre.
std::vector<Vec3> cloud(Random& random, const Vec3& centre, const Vec3& size, std::size_t count = 40) {
  const Mat3 axes = test::random_rotation(random);
  std::vector<Vec3> points;
  while (points.size() < count) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    points.push_back(centre + ((size.x * x * axes[0] + size.y * y * axes[1]) + size.z * z * axes[2]));
  }
  return points;
}

TYPED_TEST(EveryVolume, OfNothingIsEmpty) {
  const TypeParam empty = fit<TypeParam>(std::span<const Vec3>());
  EXPECT_TRUE(is_empty(empty));
  EXPECT_TRUE(is_empty(fit<TypeParam>(std::span<const Triangle>())));
  EXPECT_TRUE(is_empty(posed(empty, Pose{})));
  EXPECT_TRUE(is_empty(box_around(empty)));
  EXPECT_TRUE(is_empty(merge(empty, empty)));
  EXPECT_FALSE(contains(empty, Vec3{}));
  EXPECT_EQ(measure(empty), 0);
  EXPECT_EQ(half_area(empty), 0);
  const TypeParam other = fit<TypeParam>(std::vector<Vec3>{{1, 2, 3}, {4, 5, 7}});
  EXPECT_FALSE(overlap(empty, other));
  EXPECT_EQ(gap(empty, other), HUGE_VAL);
  EXPECT_EQ(sweep_entry(empty, {1, 0, 0}, other), HUGE_VAL);
  EXPECT_TRUE(contains(merge(empty, other), Vec3{4, 5, 7}));
  EXPECT_TRUE(contains(merge(other, empty), Vec3{1, 2, 3}));
}

TYPED_TEST(EveryVolume, RefusesWhatIsNoPoint) {
  for (const double bad : {HUGE_VAL, std::nan(""), 1e305})
    EXPECT_THROW(static_cast<void>(fit<TypeParam>(std::vector<Vec3>{{0, 0, 0}, {0, bad, 0}})), Error);
}

TYPED_TEST(EveryVolume, AnswersWithNumbersWhereTheyOverflow) {
  const TypeParam large = fit<TypeParam>(std::vector<Vec3>{{-1e300, 0, 0}, {1e300, 1e300, 0}, {0, 0, -1e300}});
  const Pose growing{{{Vec3{1e200, 0, 0}, Vec3{0, 1e200, 0}, Vec3{0, 0, 1e200}}}, {1e308, 0, -1e308}};
  const TypeParam overflown = posed(large, growing);
  EXPECT_EQ(gap(overflown, large), 0);
  EXPECT_EQ(gap(large, overflown), 0);
  EXPECT_TRUE(overlap(overflown, large));
  EXPECT_EQ(sweep_entry(overflown, {1, 1, 1}, large), 0);
  EXPECT_FALSE(std::isnan(half_area(overflown)));
}

/// The distance of two volumes that are apart is found, nearly, and so is the time at which one moving meets the other.
TYPED_TEST(EveryVolume, HoldsWhatIsFiniteWhereOneAxisOverflows) {
  const std::vector<Vec3> points{{1, 0.9, -1}, {-0.5, -0.5, 0.2}};
  const TypeParam fitted = fit<TypeParam>(points);
  for (const double offset : {0.0, 1e308}) {
    Pose pose;
    pose.linear[0] = {1e308, 1e308, 1e308};
    pose.offset.x = offset;
    const TypeParam overflown = posed(fitted, pose);
    const Vec3 world = transform(pose, points[1]);
    ASSERT_TRUE(is_finite(world));
    EXPECT_TRUE(contains(overflown, world));
    EXPECT_TRUE(overlap(overflown, overflown));
    EXPECT_EQ(gap(overflown, PointVolume{world}), 0);
    EXPECT_FALSE(std::isnan(measure(overflown)) || std::isnan(surface_area(overflown)) ||
                 std::isnan(half_area(overflown)));
    EXPECT_TRUE(contains(merge(overflown, fitted), points[0]));
  }
}

TYPED_TEST(EveryVolume, HoldsPointsOfTheLeastNumbers) {
  for (const double size : {5e-324, 1e-321, 1e-310, 1e-290}) {
    const std::vector<Vec3> points{
        {5 * size, size, 0}, {-8 * size, 3 * size, 9 * size}, {2 * size, -9 * size, 4 * size}};
    const TypeParam fitted = fit<TypeParam>(points);
    const TypeParam merged = merge(fitted, fit<TypeParam>(std::vector<Vec3>{{size, size, size}}));
    for (const Vec3& p : points) {
      EXPECT_TRUE(contains(fitted, p)) << size;
      EXPECT_TRUE(contains(merged, p)) << size;
      EXPECT_TRUE(contains(merge(fitted, TypeParam{}), p)) << size;
      EXPECT_TRUE(contains(posed(fitted, Pose::translation(0, 0, size)), p + Vec3{0, 0, size})) << size;
    }
  }
}

TYPED_TEST(EveryVolume, GapAndEntryAreNearTheTruth) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(Random(seed).bits());
    const TypeParam a = fit<TypeParam>(cloud(random, {}, {1, 0.5, 0.2}));
    const TypeParam b = fit<TypeParam>(cloud(random, {3, 3, 2}, {1, 0.5, 0.2}));
    const double apart = gap(a, b);
    ASSERT_GT(apart, 0);
    EXPECT_FALSE(overlap(a, b));
    if constexpr (test::HasExactSet<TypeParam>) {
      EXPECT_GE(oracle::compare_distance(test::exact_set(a), test::exact_set(b), oracle::exact(apart)), 0);
      EXPECT_LE(oracle::compare_distance(test::exact_set(a), test::exact_set(b), oracle::exact(apart * (1 + 1e-6))), 0);
    }
    // The search for a direction may go wrong by what a corner is cut off; not by more than this.
    const Vec3 motion = 2.0 * (middle(b) - middle(a));
    const double entry = sweep_entry(a, motion, b);
    ASSERT_LT(entry, 1);
    const TypeParam before = posed(a, Pose{{}, entry * motion}), after = posed(a, Pose{{}, (entry + 0.01) * motion});
    EXPECT_LT(gap(before, b), 1e-4);
    EXPECT_TRUE(overlap(after, b));
    EXPECT_EQ(sweep_entry(a, -motion, b), HUGE_VAL);
    const double hit = ray_entry(middle(a), motion, b);
    EXPECT_GE(hit, entry - 1e-9);
    EXPECT_LT(hit, 0.5);
    EXPECT_LT(gap(b, PointVolume{middle(a) + hit * motion}), 1e-4);
    EXPECT_EQ(ray_entry(middle(a), -motion, b), HUGE_VAL);
  }
}

TYPED_TEST(EveryVolume, ASinglePointHasHardlyAnySize) {
  const std::vector<Vec3> point{{1, -2, 3}, {1, -2, 3}};
  const TypeParam v = fit<TypeParam>(point);
  EXPECT_TRUE(contains(v, point[0]));
  EXPECT_LT(measure(v), 1e-30);
  EXPECT_NEAR(gap(v, PointVolume{{1, -2, 5}}), 2, 1e-12);
}

/// Far from the origin a volume is as tight as near to it, but for the last places of the coordinates.
TYPED_TEST(EveryVolume, IsTightFarFromTheOrigin) {
  Random random(5);
  const std::vector<Vec3> near = cloud(random, {}, {1, 0.7, 0.4});
  std::vector<Vec3> far;
  for (const Vec3& p : near) far.push_back(p + Vec3{1e6, -1e6, 1e6});
  EXPECT_NEAR(measure(fit<TypeParam>(far)) / measure(fit<TypeParam>(near)), 1, 1e-3);
  EXPECT_NEAR(measure(posed(fit<TypeParam>(near), Pose::translation(1e6, 1e6, 1e6))) / measure(fit<TypeParam>(near)), 1,
              1e-3);
}

TYPED_TEST(EveryVolume, IsAsTightForTinyPoints) {
  Random random(6);
  const std::vector<Vec3> points = cloud(random, {}, {1, 0.7, 0.4});
  const Pose shrinking{{{Vec3{0x1p-300, 0, 0}, Vec3{0, 0x1p-300, 0}, Vec3{0, 0, 0x1p-300}}}, {}};
  const double here = half_area(fit<TypeParam>(points));
  EXPECT_NEAR(half_area(fit<TypeParam>(transform(shrinking, points))) * 0x1p600 / here, 1, 1e-9);
}

/// A corner near the plane x = 0 of a box that is 10⁵ times as long: its x is what large numbers leave when they
/// cancel, and is off by their rounding, not by its own.
TYPED_TEST(EveryVolume, FarthestPointIsOffByRoundingOfTheLargestCoordinates) {
  const std::vector<Vec3> points{{-0x1.f31a1f9e7e468p+993, 0x1.57894984fd023p+994, 0x1.ba9c45da4754ep+995},
                                 {-0x1.6f0d36991af5p+995, 0x1.28468587c7463p+996, 0x1.4137e2d3cb8e7p+995},
                                 {-0x1.d81b732644dfbp+994, 0x1.18522e04a514cp+994, 0x1.7cb94b48cc6p+990},
                                 {-0x1.dd622a6ebe254p+992, 0x1.4e06dd1ddb84ep+993, 0x1.f7199e42105e8p+995},
                                 {-0x1.100d0a440d4fp+992, 0x1.651fa5923f4a9p+995, 0x1.38af6220ce559p+994},
                                 {-0x1.f6204214a012ap+995, 0x1.bffb7066351a6p+994, 0x1.824ea3a7729c8p+995}};
  const Pose pose{{{Vec3{0x1.bc6ee19284a6cp-2, 0x1.7ce70f3ee6561p-3, -0x1.c353a8c7151fp-1},
                    Vec3{0x1.6ff55964f7c77p-1, 0x1.098116d44743dp-1, 0x1.da6037402bd2bp-2},
                    Vec3{0x1.1627c7401d22bp-1, -0x1.ab4c48b525d9bp-1, 0x1.7661790577848p-4}}},
                  {-0x1.53d1f0bdbf44ep+993, -0x1.304292e1c4428p+995, 0x1.3d5f6be3926ecp+994}};
  const TypeParam turned = posed(fit<TypeParam>(points), pose);
  for (const Vec3& p : points) EXPECT_TRUE(test::holds(turned, transform(pose, p)));
  const Vec3 far = farthest_point(turned, {1, -0.5, 0.25});
  EXPECT_TRUE(test::holds_but_for_rounding(box_around(turned), far.x));
}

/// Turning a tight volume does not make it looser, where it can turn.
TYPED_TEST(EveryVolume, RotationsKeepWhatCanTurn) {
  Random random(7);
  const TypeParam v = fit<TypeParam>(cloud(random, {}, {1, 0.5, 0.1}));
  const double ratio = measure(posed(v, Pose{test::random_rotation(random), {1, 2, 3}})) / measure(v);
  EXPECT_GE(ratio, 1 - 1e-9);
  if (test::can_turn<TypeParam>) {
    EXPECT_LT(ratio, 1 + 1e-4);
  } else {
    EXPECT_GT(ratio, 1.01);
  }
}

TEST(Tightness, NothingIsTighterThanTheHull) {
  Random random(8);
  const std::vector<Vec3> points = cloud(random, {}, {1, 0.5, 0.1}, 200);
  const ConvexHull hull(points);
  const auto fill = [&](const auto& volume) { return tightness(volume, hull).fill; };
  EXPECT_NEAR(fill(fit<HullBound>(points)), 1, 1e-12);
  const double box = fill(fit<Kdop<6>>(points)), dop14 = fill(fit<Kdop<14>>(points));
  const double dop18 = fill(fit<Kdop<18>>(points)), dop26 = fill(fit<Kdop<26>>(points));
  EXPECT_NEAR(box, fill(fit<Aabb>(points)), 1e-12);
  EXPECT_LT(box, dop14);
  EXPECT_LT(box, dop18);
  EXPECT_LT(dop14, dop26);
  EXPECT_LT(dop18, dop26);
  EXPECT_LT(dop26, 1);
  // A turned plate is what oriented boxes are for.
  EXPECT_GT(fill(fit<Obb>(points)), 0.6);
  EXPECT_LT(box, 0.5);
  EXPECT_LT(fill(fit<Ball>(points)), 0.1);
  EXPECT_LT(fill(fit<Cube>(points)), 0.1);
}

TEST(Tightness, SizesOfKnownSolids) {
  std::vector<Vec3> corners;
  for (const double x : {0.0, 2.0})
    for (const double y : {0.0, 4.0})
      for (const double z : {0.0, 8.0}) corners.push_back({x, y, z});
  EXPECT_DOUBLE_EQ(measure(fit<Kdop<6>>(corners)), 64);
  EXPECT_DOUBLE_EQ(surface_area(fit<Kdop<26>>(corners)), 112);
  EXPECT_DOUBLE_EQ(measure(fit<HullBound>(corners)), 64);
  EXPECT_DOUBLE_EQ(surface_area(fit<HullBound>(corners)), 112);
  EXPECT_NEAR(measure(fit<Obb>(corners)), 64, 1e-9);
  EXPECT_DOUBLE_EQ(measure(Rss{{}, {}, {1, 2}, 0.5}), 8 + 6 * std::numbers::pi / 4 * 1 + std::numbers::pi / 6);
  EXPECT_DOUBLE_EQ(surface_area(Lss{{}, {}, {3}, 1}), 16 * std::numbers::pi);
  EXPECT_NEAR(surface_area(EllipsoidBound{{}, {}, {1, 1, 1}}), 4 * std::numbers::pi, 1e-12);
  // The least ellipsoid around a cube is the ball through its corners.
  const EllipsoidBound around = fit<EllipsoidBound>(std::vector<Vec3>{
      {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}, {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}});
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(around.half[axis], std::sqrt(3), 1e-9);
}

}  // namespace
}  // namespace toccata
